// The share of the sun's disc above an edge at q, -1 .. 1, of its radius: as terrain::shareOfDisc.
float shareOfDisc(float q) {
  float x = clamp(q, -1.0, 1.0);
  float square = x * x;
  return 0.5 + x * (0.6297 - square * (0.0679 + 0.0618 * square));
}
