#!/usr/bin/env python3
"""A server on 127.0.0.1 that answers as its path says, well and badly. Writes its port to the file that is
named, and ends with its parent. /file sends the answer file as it is by then.

    weather_server.py PORT_FILE ANSWER_FILE
"""

import gzip
import os
import socket
import sys
import threading
import time
import zlib

ANSWER = open(sys.argv[2], "rb").read()
COUNTS = {}
LOCK = threading.Lock()


def head(status, length, *more):
    lines = ["HTTP/1.1 " + status, "Connection: close"]
    if length is not None:
        lines.append("Content-Length: %d" % length)
    return ("\r\n".join(lines + list(more)) + "\r\n\r\n").encode()


def serve(connection):
    data = b""
    while b"\r\n\r\n" not in data:
        piece = connection.recv(4096)
        if not piece:
            return
        data += piece
    lines = data.decode("latin-1").split("\r\n")
    path = lines[0].split(" ")[1].split("?")[0]
    with LOCK:
        count = COUNTS[path] = COUNTS.get(path, 0) + 1
    send = connection.sendall
    if path == "/good":
        send(head("200 OK", len(ANSWER)) + ANSWER)
    elif path == "/tagged":
        if any(line.lower() == 'if-none-match: "v1"' for line in lines):
            send(head("304 Not Modified", None, 'ETag: "v1"'))
        else:
            send(head("200 OK", len(ANSWER), 'ETag: "v1"') + ANSWER)
    elif path == "/file":
        body = open(sys.argv[2], "rb").read()
        tag = '"%08x"' % zlib.crc32(body)
        if any(line.lower() == "if-none-match: " + tag for line in lines):
            send(head("304 Not Modified", None, "ETag: " + tag))
        else:
            send(head("200 OK", len(body), "ETag: " + tag) + body)
    elif path == "/gzip":
        packed = gzip.compress(ANSWER)
        send(head("200 OK", len(packed), "Content-Encoding: gzip") + packed)
    elif path == "/bomb":
        packed = gzip.compress(b" " * (64 << 20))
        send(head("200 OK", len(packed), "Content-Encoding: gzip") + packed)
    elif path == "/notgzip":
        send(head("200 OK", len(ANSWER), "Content-Encoding: gzip") + ANSWER)
    elif path == "/stalls":
        send(head("200 OK", len(ANSWER)) + ANSWER[:100])
        time.sleep(60)
    elif path == "/silent":
        time.sleep(60)
    elif path == "/short":
        send(head("200 OK", len(ANSWER) + 1000) + ANSWER)
    elif path == "/cut":
        send(head("200 OK", len(ANSWER) // 2) + ANSWER)
    elif path == "/endless":
        send(head("200 OK", None))
        while True:
            send(b" " * 65536)
    elif path == "/circle":
        send(head("302 Found", 0, "Location: /circle"))
    elif path == "/once":
        send(head("302 Found", 0, "Location: /good"))
    elif path == "/away":
        send(head("302 Found", 0, "Location: file:///etc/passwd"))
    elif path == "/busy":
        send(head("429 Too Many Requests", 0, "Retry-After: 1000000"))
    elif path == "/recovers":
        send(head("500 Internal Server Error", 0) if count < 3 else head("200 OK", len(ANSWER)) + ANSWER)
    elif path == "/error":
        send(head("500 Internal Server Error", 0))
    elif path == "/refuses":
        body = b'{"error":true,"reason":"no such place"}'
        send(head("400 Bad Request", len(body)) + body)
    elif path == "/garbage":
        body = bytes((i * 73 + 11) % 256 for i in range(5000))
        send(head("200 OK", len(body)) + body)
    elif path == "/nothttp":
        send(b"\x00\x01\x02 this is no HTTP\r\n\r\n")
    elif path == "/counts":
        body = repr(COUNTS).encode()
        send(head("200 OK", len(body)) + body)
    else:
        send(head("404 Not Found", 0))


def guarded(connection):
    try:
        with connection:
            serve(connection)
    except OSError:
        pass


def main():
    listener = socket.socket()
    listener.bind(("127.0.0.1", 0))
    listener.listen(64)
    with open(sys.argv[1] + ".new", "w", encoding="utf-8") as port:
        port.write(str(listener.getsockname()[1]))
    os.replace(sys.argv[1] + ".new", sys.argv[1])
    while True:
        connection, _ = listener.accept()
        threading.Thread(target=guarded, args=(connection,), daemon=True).start()


main()
