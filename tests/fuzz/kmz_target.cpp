// A KMZ archive, as bytes, or one of two documents with changes of its bytes.
#include "base/error.h"
#include "fuzz/target.h"
#include "plan/kml_reader.h"
#include "plan/kml_writer.h"

namespace {

const std::string& sound_archive() {
  static const std::string archive = lsos::pack_kmz(
      "<kml xmlns='http://www.opengis.net/kml/2.2'><Document><NetworkLink><Link><href>layers/a.kml"
      "</href></Link></NetworkLink><Placemark><name>A</name><ExtendedData><SchemaData "
      "schemaUrl='#Rover'><SimpleData name='RoverId'>A</SimpleData></SchemaData></ExtendedData>"
      "<Point><coordinates>1,2</coordinates></Point></Placemark></Document></kml>",
      {{"layers/a.kml",
        "<kml><Placemark><name>B</name><LineString><coordinates>1,2 3,4</coordinates></LineString>"
        "</Placemark></kml>"}});
  return archive;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lsos::test::Bytes bytes(data, size);
  const bool is_whole = bytes.byte() % 2 == 0;
  try {
    lsos::parse_kml(is_whole ? bytes.rest() : lsos::test::patched(sound_archive(), bytes),
                    "plan.kmz");
  } catch (const lsos::InputError&) {
  }
  return 0;
}
