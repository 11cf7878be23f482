# Every third-party library, found once and given one target name. Headers count as
# system headers, so their warnings are not ours.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(PNG REQUIRED)
find_package(Freetype REQUIRED)
find_package(JPEG REQUIRED)

pkg_check_modules(lua REQUIRED IMPORTED_TARGET lua5.4-c++)
pkg_check_modules(bullet REQUIRED IMPORTED_TARGET bullet-float64)
pkg_check_modules(gdal REQUIRED IMPORTED_TARGET gdal)
pkg_check_modules(proj REQUIRED IMPORTED_TARGET proj)
pkg_check_modules(sqlite3 REQUIRED IMPORTED_TARGET sqlite3)
pkg_check_modules(erfa REQUIRED IMPORTED_TARGET erfa)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(tinyxml2 REQUIRED IMPORTED_TARGET tinyxml2)
pkg_check_modules(libxml2 REQUIRED IMPORTED_TARGET libxml-2.0)
pkg_check_modules(libzip REQUIRED IMPORTED_TARGET libzip)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo)
pkg_check_modules(libedit REQUIRED IMPORTED_TARGET libedit)
find_path(OMPL_INCLUDE_DIR ompl/config.h PATH_SUFFIXES ompl-1.5 REQUIRED)
find_library(OMPL_LIBRARY ompl REQUIRED)
add_library(ompl INTERFACE)
target_include_directories(ompl SYSTEM INTERFACE ${OMPL_INCLUDE_DIR})
target_link_libraries(ompl INTERFACE ${OMPL_LIBRARY} Eigen3::Eigen)
find_path(CLI11_INCLUDE_DIR CLI/CLI.hpp REQUIRED)

# Charts of report.html, which carries a copy.
find_file(DYGRAPHS_JS dygraph.min.js PATHS /usr/share/javascript/dygraphs
          /usr/share/nodejs/dygraphs/dist NO_DEFAULT_PATH)
if(NOT DYGRAPHS_JS)
  message(FATAL_ERROR "dygraphs is not installed: apt-get install libjs-dygraphs, "
                      "or -DDYGRAPHS_JS=/path/of/dygraph.min.js")
endif()
