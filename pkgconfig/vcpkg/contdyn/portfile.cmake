# The sources are those that this file lies in: pkgconfig/vcpkg/contdyn.
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../../.." ABSOLUTE)

vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS -DCONTDYN_TESTS=OFF -DCONTDYN_REPORT=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/contdyn)
vcpkg_fixup_pkgconfig()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
set(VCPKG_POLICY_DLLS_IN_STATIC_LIBRARY enabled) # both are always there: contdyn::contdyn and contdyn::contdyn_static
file(WRITE "${CURRENT_PACKAGES_DIR}/share/${PORT}/copyright" "No licence has been chosen yet.\n")
