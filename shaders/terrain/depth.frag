// The land's depth is all that is drawn of its mesh; terrain/shade.frag gives it light.
void main() {}
