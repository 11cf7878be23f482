// What an edit does not touch stays as it was.
#include "edit/kml_dom.h"

#include "edit/enable.h"
#include "edit/renumber.h"
#include "edit_fixture.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

// What map tools leave in a plan: other namespaces, comments, CDATA, styles, overlays.
const std::string foreign = R"(<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
<!-- before -->
<k:kml xmlns:k="http://www.opengis.net/kml/2.2" xmlns:gx="http://www.google.com/kml/ext/2.2"
       k:hint='target=moon'>
  <k:Document id = "d">
	<k:name>A &amp; B &#xE9; — é</k:name>
    <k:Style id="s"><k:IconStyle><k:color>ff0000ff</k:color></k:IconStyle></k:Style>
    <k:GroundOverlay><k:Icon><k:href>a.png?x=1&amp;y=2</k:href></k:Icon></k:GroundOverlay>
    <gx:Tour><gx:Playlist/></gx:Tour>
    <k:Folder><k:name>plan</k:name>
      <k:Placemark id="m"><k:ExtendedData><k:SchemaData schemaUrl="#MissionInfo">
        <k:SimpleData name="Planet">Moon</k:SimpleData><k:SimpleData name="StartTime">2026-07-01</k:SimpleData>
        <k:SimpleData name="Terrain">Flat</k:SimpleData></k:SchemaData></k:ExtendedData></k:Placemark>
      <k:Placemark><k:ExtendedData><k:SchemaData schemaUrl="#Rover"><k:SimpleData name="RoverId">A</k:SimpleData>
        <k:SimpleData name="RoverType">SEV</k:SimpleData></k:SchemaData></k:ExtendedData>
        <k:Point><k:coordinates>31,20</k:coordinates></k:Point></k:Placemark>
      <k:Placemark id="p"><k:name><![CDATA[stay <here>]]></k:name><k:styleUrl>#s</k:styleUrl>
        <k:description><![CDATA[<b>bold</b> & more]]></k:description>
        <k:ExtendedData><!-- why --><k:SchemaData schemaUrl="#Pause"><k:SimpleData name="RoverId">A</k:SimpleData>
        <k:SimpleData name="Sequence"> 7 <!-- seven --></k:SimpleData><k:SimpleData name="Duration">60</k:SimpleData>
        </k:SchemaData><k:Data name="colour"><k:value>red</k:value></k:Data><own xmlns="urn:x" a="1"/></k:ExtendedData></k:Placemark>
    </k:Folder>
    <k:Placemark><k:name>hill</k:name><k:Point><k:coordinates>31,20,5</k:coordinates></k:Point></k:Placemark>
  </k:Document>
</k:kml>
<!-- behind -->
)";

class ForeignPlan {
 public:
  explicit ForeignPlan(const std::string& bytes = foreign)
      : bytes_(bytes),
        known_(declarations()),
        plan_(read_text(bytes_, known_)),
        document(bytes_, plan_, known_) {}

 private:
  std::string bytes_;
  Declarations known_;
  Plan plan_;

 public:
  PlanDocument document;
};

TEST(KmlDom, writes_what_it_read) {
  ForeignPlan plan;
  EXPECT_EQ(canonical(plan.document.text()), canonical(foreign));
  EXPECT_THAT(plan.document.text(), HasSubstr("<![CDATA[<b>bold</b> & more]]>"));
  EXPECT_THAT(plan.document.text(), HasSubstr("standalone=\"yes\""));
}

TEST(KmlDom, changes_one_text_and_nothing_else) {
  ForeignPlan plan;
  EXPECT_EQ(renumber(plan.document, 10, ""), 1);
  EXPECT_EQ(canonical(plan.document.text()),
            canonical(replaced(foreign, " 7 <!-- seven -->", " 10 <!-- seven -->")));
}

TEST(KmlDom, adds_a_field_in_the_namespace_and_the_lines_of_its_neighbours) {
  ForeignPlan plan;
  const std::vector<const PlanEvent*> events{&plan.document.plan().events.front()};
  EXPECT_EQ(set_enabled(plan.document, events, false), 1);
  const std::string added =
      "60</k:SimpleData><k:SimpleData name=\"Enabled\">false</k:SimpleData>\n        "
      "</k:SchemaData>";
  EXPECT_EQ(canonical(plan.document.text()),
            canonical(replaced(foreign, "60</k:SimpleData>\n        </k:SchemaData>", added)));
}

TEST(KmlDom, keeps_the_line_ends_of_windows) {
  const std::string windows = replaced(foreign, "\n", "\r\n");
  ForeignPlan plan(windows);
  const std::string text = plan.document.text();
  EXPECT_EQ(replaced(text, "\r\n", "\n").find('\r'), std::string::npos);
  EXPECT_EQ(std::ranges::count(text, '\n'), std::ranges::count(text, '\r'));
}

TEST(KmlDom, writes_other_encodings_as_utf_8) {
  const std::string latin = replaced(
      replaced(replaced(foreign, "encoding=\"UTF-8\"", "encoding=\"ISO-8859-1\""), " — é", ""),
      "&#xE9;", "\xE9");
  ForeignPlan plan(latin);
  EXPECT_THAT(plan.document.text(), HasSubstr("encoding=\"UTF-8\""));
  EXPECT_THAT(plan.document.text(), HasSubstr("A &amp; B é"));
}

TEST(KmlDom, adds_no_declaration_where_there_was_none) {
  const std::string bare = foreign.substr(foreign.find("<k:kml"));
  ForeignPlan plan(bare);
  EXPECT_TRUE(plan.document.text().starts_with("<k:kml"));
}

TEST(KmlDom, says_what_cannot_be_edited) {
  try {
    const KmlDom dom("<kml>\n<a>&nbsp;</a></kml>", "plan.kml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("plan.kml:2: cannot be edited, though it can be read: "
                                        "Entity 'nbsp'"));
  }
}

TEST(KmlDom, reads_nothing_else) {
  // The entity is left as it is, and the file is not opened.
  const std::string text =
      "<!DOCTYPE kml [<!ENTITY e SYSTEM \"/etc/hostname\">]><kml><a>&e;</a></kml>";
  const KmlDom dom(text, "plan.kml");
  EXPECT_THAT(dom.text(), HasSubstr("<a>&e;</a>"));
}

// Google Earth declares KML's namespace twice, and GDAL knows elements without a prefix alone.
TEST(KmlDom, names_copies_as_what_is_around_them) {
  const std::string twice =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<kml xmlns=\"http://www.opengis.net/kml/2.2\" "
      "xmlns:gx=\"http://www.google.com/kml/ext/2.2\" "
      "xmlns:kml=\"http://www.opengis.net/kml/2.2\"><Document><Folder><name>a</name>"
      "<Placemark><name>p</name><gx:x><y/></gx:x></Placemark></Folder></Document></kml>\n";
  KmlDom dom(twice, "plan.kml");
  const KmlElement placemark = dom.placemarks().front();
  dom.copy_behind(placemark, placemark);
  const KmlDom other(
      "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Folder><name>b</name>"
      "<Placemark/></Folder></Document></kml>",
      "other.kml");
  dom.copy_into(children(other.container()).front(), dom.container());
  dom.add_feature_part(dom.placemarks().front(), "description", "d");
  const std::string text = dom.text();
  EXPECT_EQ(text.find("<kml:"), std::string::npos) << text;
  EXPECT_THAT(text, HasSubstr("<gx:x><y/></gx:x></Placemark><Placemark><name>p</name><gx:x><y/>"));
  EXPECT_THAT(text, HasSubstr("<Folder><name>b</name><Placemark/></Folder></Document>"));
}

TEST(KmlDom, keeps_the_prefix_of_what_is_around_copies) {
  ForeignPlan plan;
  KmlDom& dom = plan.document.dom();
  const KmlElement last = dom.placemarks().back();
  dom.copy_behind(last, last);
  const KmlDom other("<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Folder/></kml>", "other.kml");
  dom.copy_into(children(other.root()).front(), dom.container());
  const std::string text = dom.text();
  EXPECT_THAT(text, HasSubstr("<k:Folder/>"));
  EXPECT_EQ(text.find("<Placemark"), std::string::npos);
}

}  // namespace
}  // namespace lsos::test
