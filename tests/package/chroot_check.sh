#!/usr/bin/env bash
# Tries the packages on a bare Debian: installs, flies without a display, writes an accuracy report, removes.
#   chroot_check.sh DEB ZIP FOLDER     needs root, debootstrap and the network; FOLDER is made and kept
set -euo pipefail
deb=$(realpath "$1") zip=$(realpath "$2") root=$3
[ ! -e "$root" ] || { echo "chroot_check.sh: $root is there already" >&2; exit 1; }

mirror=${DEBIAN_MIRROR:-http://deb.debian.org/debian}
debootstrap --variant=minbase bookworm "$root" "$mirror" >/dev/null
mount -t proc proc "$root/proc"  # by which a program knows where it lies
trap 'umount "$root/proc"' EXIT
inside() { chroot "$root" env -i PATH=/usr/bin:/bin:/usr/sbin:/sbin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
# The proxy and certificates of this machine's apt, where it has them.
rm -f "$root/etc/apt/sources.list"
for part in /etc/apt/apt.conf.d /etc/apt/sources.list /etc/apt/sources.list.d /etc/ssl/certs; do
  [ ! -e "$part" ] || cp -rL "$part" "$root/$(dirname "$part")/"
done
cp /etc/resolv.conf "$root/etc/resolv.conf"
inside apt-get update -qq
inside dpkg-query -W -f='${Package}\n' | sort >"$root/before.txt"

echo "== the package"
cp "$deb" "$root/skydrop.deb"
inside apt-get install -y -qq /skydrop.deb >/dev/null
inside skydrop --version
inside skydrop render --scene fair --size 320x180 --autopilot --time 2 --out /tmp/flight.png
inside skydrop simulate --autopilot --seconds 30
inside skydrop accuracy --quick depth land-lod --out /tmp/report >/dev/null
test -s "$root/tmp/report/accuracy.html"
inside dpkg --verify skydrop
inside apt-get purge -y -qq skydrop >/dev/null
left=$(find "$root/usr" "$root/etc" -iname '*skydrop*' | wc -l)
[ "$left" -eq 0 ] || { echo "chroot_check.sh: $left files are left" >&2; exit 1; }

echo "== the archive, moved"
inside apt-get install -y -qq /skydrop.deb >/dev/null && inside dpkg --remove skydrop >/dev/null  # its libraries stay
mkdir "$root/opt/somewhere"
python3 -c 'import sys, zipfile; zipfile.ZipFile(sys.argv[1]).extractall(sys.argv[2])' "$zip" "$root/opt/somewhere"
program=$(cd "$root" && find opt/somewhere -path '*/bin/skydrop')
chmod +x "$root/$program"
inside "/$program" info | sed -n 1,2p
inside "/$program" render --scene duskPlanes --size 160x90 --out /tmp/moved.png
echo "== all is well"
