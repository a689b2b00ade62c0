// Where the tests find things. Defined in one file, so that compiled tests do not depend on where the sources
// lie and several clones share a compiler cache. In a bundle all of them lie in $SKYDROP_TEST_BUNDLE.
#pragma once

#include <string>

namespace skydrop::test {

std::string sourceDir();    // of the repository
std::string binaryDir();    // of this build
std::string programFile();  // the built skydrop

}  // namespace skydrop::test
