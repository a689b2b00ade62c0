# What is installed, and the packages made of it: `cpack --preset package` (docs/packaging.md).
#
#   bin/skydrop   share/skydrop/{assets,shaders}   share/{applications,metainfo,icons,doc}
#
# The program looks for its data beside itself, so the tree may be moved as a whole.
include(GNUInstallDirs)

install(TARGETS skydrop RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY assets/ DESTINATION ${CMAKE_INSTALL_DATADIR}/skydrop/assets
        PATTERN scripts EXCLUDE PATTERN desktop EXCLUDE PATTERN SOURCES.md EXCLUDE)
install(DIRECTORY shaders/ DESTINATION ${CMAKE_INSTALL_DATADIR}/skydrop/shaders)
install(FILES assets/desktop/skydrop.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES assets/desktop/skydrop.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES assets/desktop/skydrop.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES README.md assets/SOURCES.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/skydrop)

set(CPACK_GENERATOR DEB ZIP)
set(CPACK_PACKAGE_NAME skydrop)
set(CPACK_PACKAGE_VENDOR "The Skydrop developers")
set(CPACK_PACKAGE_CONTACT "The Skydrop developers <skydrop@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "flight game over endless land under volumetric clouds")
set(CPACK_PACKAGE_DESCRIPTION
    "Find the target, drop the package. Shows what accuracy costs in time, stays numerically stable where it
is hard, and simulates only the effects that a scene calls for. Needs OpenGL 4.5.")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_FILE_NAME "skydrop-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION games)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Loaded while it runs: software rendering without a display.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri, libosmesa6")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_ZIP_PACKAGING_INSTALL_PREFIX /)
include(CPack)
