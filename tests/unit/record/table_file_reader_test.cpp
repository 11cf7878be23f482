// Tables whose columns are known at run time come back as they were written.
#include "record/table_file_reader.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

TEST(TableFileReader, gives_back_what_was_written) {
  const TestFolder folder;
  const std::string file = folder / "table.gpkg";
  const Geodetic place = geodetic_from_degrees(-10.5, -89.25, 12);
  TableFile table(file, moon_crs);
  table.begin({"ends",
               LayerGeometry::point,
               {{"case", ColumnType::integer}, {"SEV1/20.Speed"}, {"why", ColumnType::text}}});
  table.write({std::int64_t{3}, 0.1, std::string("<'\"&")}, place);
  table.write({std::int64_t{4}, {}, {}});
  table.begin({"none", LayerGeometry::none, {{"a"}}});
  table.finish();

  const TableFileReader reader(file);
  const std::vector<TableColumn> columns = reader.columns("ends");
  ASSERT_EQ(columns.size(), 3u);
  EXPECT_EQ(columns[0].type, ColumnType::integer);
  EXPECT_EQ(columns[1].name, "SEV1/20.Speed");
  EXPECT_EQ(columns[1].type, ColumnType::real);
  EXPECT_EQ(columns[2].type, ColumnType::text);
  const std::vector<FileRow> rows = reader.rows("ends");
  ASSERT_EQ(rows.size(), 2u);
  const std::vector<ColumnValue> first{std::int64_t{3}, 0.1, std::string("<'\"&")};
  EXPECT_EQ(rows[0].values, first);
  ASSERT_TRUE(rows[0].place);
  EXPECT_DOUBLE_EQ(lon_deg(*rows[0].place), -10.5);
  EXPECT_EQ(rows[1].values[1], ColumnValue{});
  EXPECT_FALSE(rows[1].place);
  EXPECT_TRUE(reader.rows("none").empty());
}

TEST(TableFileReader, tells_what_is_not_there) {
  const TestFolder folder;
  const std::string file = folder / "table.gpkg";
  EXPECT_THROW(TableFileReader{file}, InputError);
  TableFile table(file, moon_crs);
  table.begin({"a", LayerGeometry::none, {{"b"}}});
  table.finish();
  try {
    TableFileReader(file).rows("cases");
    FAIL() << "there is no such layer";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("table.gpkg: has no layer 'cases'"));
  }
}

}  // namespace
}  // namespace lsos
