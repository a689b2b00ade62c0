#include "app/cli/verbs.h"

int main(int argc, char** argv) { return skydrop::app::runProgram(argc, argv); }
