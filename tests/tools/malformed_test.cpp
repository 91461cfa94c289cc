#include <algorithm>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "tools/command.hpp"

namespace waywright::test {
namespace {

struct Malformed {
  std::string name;
  std::string text;
  int line = 0;
};

void PrintTo(const Malformed& malformed, std::ostream* out) { *out << malformed.name; }

std::string name_of(const testing::TestParamInfo<Malformed>& info) { return info.param.name; }

/// Expects status 2, nothing on standard output, and one line on standard error that starts with the file and the line.
void expect_malformed(const CommandResult& result, const std::string& file, int line) {
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  const std::string prefix = file + ":" + std::to_string(line) + ": ";
  EXPECT_EQ(result.err.substr(0, prefix.size()), prefix);
  EXPECT_GT(result.err.size(), prefix.size() + 10) << "says nothing about what is wrong";
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_TRUE(result.err.ends_with('\n'));
}

class MalformedScript : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedScript, EndsWithStatus2AndLeavesNothing) {
  const TemporaryFolder folder;
  const std::string script = folder.file("broken.wws", GetParam().text);
  const auto result = run_command({"run", script, "--dump", folder.file("dump"), "--svg", folder.file("svg")});
  expect_malformed(result, script, GetParam().line);
  EXPECT_EQ(folder.file_count(), 1U);

  expect_malformed(run_script(GetParam().text), "-", GetParam().line);
  expect_malformed(run_command({"path", script, "--from", "1", "1", "--to", "2", "2"}), script, GetParam().line);
  expect_malformed(run_command({"convert", script, folder.file("out.wws")}), script, GetParam().line);
  EXPECT_EQ(folder.file_count(), 1U);
}

/// Returns a script with an error on line 3, followed by a query whose answer must not be printed.
Malformed third(const std::string& name, const std::string& line) {
  return {name, "waywright 1\ndomain 0 0 10 10\n" + line + "\nlocate 1 1\n", 3};
}

INSTANTIATE_TEST_SUITE_P(
    Beginnings, MalformedScript,
    testing::Values(Malformed{"empty", "", 1}, Malformed{"comments_only", "# nothing", 1},
                    Malformed{"header_missing", "domain 0 0 1 1\n", 1},
                    Malformed{"header_of_another_program", "wayword 1\ndomain 0 0 1 1\n", 1},
                    Malformed{"header_without_version", "\nwaywright\ndomain 0 0 1 1\n", 2},
                    Malformed{"header_of_a_later_version", "waywright 2\ndomain 0 0 1 1\n", 1},
                    Malformed{"header_with_more", "waywright 1 2\ndomain 0 0 1 1\n", 1},
                    Malformed{"header_in_capitals", "WAYWRIGHT 1\ndomain 0 0 1 1\n", 1},
                    Malformed{"header_version_no_integer", "waywright 1.0\ndomain 0 0 1 1\n", 1},
                    Malformed{"second_header", "waywright 1\nwaywright 1\ndomain 0 0 1 1\n", 2},
                    Malformed{"domain_missing", "waywright 1\n", 1},
                    Malformed{"item_before_domain", "waywright 1\npoint 1 0 0\ndomain 0 0 1 1\n", 2},
                    Malformed{"query_before_domain", "waywright 1\nlocate 0 0\ndomain 0 0 1 1\n", 2},
                    Malformed{"check_before_domain", "waywright 1\n\ncheck\ndomain 0 0 1 1\n", 3}),
    name_of);

INSTANTIATE_TEST_SUITE_P(Domains, MalformedScript,
                         testing::Values(third("second_domain", "domain 0 0 10 10"),
                                         Malformed{"no_numbers", "waywright 1\ndomain\n", 2},
                                         Malformed{"three_numbers", "waywright 1\ndomain 0 0 1\n", 2},
                                         Malformed{"five_numbers", "waywright 1\ndomain 0 0 1 1 1\n", 2},
                                         Malformed{"no_number", "waywright 1\ndomain 0 0 1 one\n", 2},
                                         Malformed{"not_a_number", "waywright 1\ndomain 0 0 nan 1\n", 2},
                                         Malformed{"no_width", "waywright 1\ndomain 1 0 1 1\n", 2},
                                         Malformed{"no_height", "waywright 1\ndomain 0 1 1 1\n", 2},
                                         Malformed{"turned_x", "waywright 1\ndomain 1 0 0 1\n", 2},
                                         Malformed{"turned_y", "waywright 1\ndomain 0 1 1 0\n", 2}),
                         name_of);

INSTANTIATE_TEST_SUITE_P(
    Operations, MalformedScript,
    testing::Values(
        third("unknown", "circle 1 2 2 1"), third("capitals", "POINT 1 2 2"), third("number_alone", "1 2 3"),
        third("remove_without_id", "remove"), third("remove_two", "remove 1 2"), third("locate_one_number", "locate 1"),
        third("locate_three_numbers", "locate 1 2 3"), third("locate_word", "locate here 2"),
        third("ray_three_numbers", "ray 1 2 3"), third("ray_six_numbers", "ray 1 2 3 4 5 6"),
        third("disc_without_radius", "disc 1 2"), third("disc_four_numbers", "disc 1 2 3 4"),
        third("nearest_without_radius", "nearest 1 2"), third("nearest_four_numbers", "nearest 1 2 3 4"),
        third("path_without_radius", "path 1 2 3 4"), third("path_unknown_algorithm", "path 1 2 3 4 0 astar"),
        third("path_two_algorithms", "path 1 2 3 4 0 ta ta"), third("path_word", "path 1 2 3 x 0"),
        third("check_with_more", "check 1"), third("hash_with_more", "hash mesh"), third("hexadecimal", "locate 0x1 2"),
        third("decimal_comma", "locate 1,5 2"), third("trailing_letter", "locate 1.5f 2"),
        third("lone_sign", "locate - 2"), third("two_signs", "locate --1 2"), third("lone_exponent", "locate 1e 2")),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Items, MalformedScript,
    testing::Values(third("point_without_id", "point"), third("point_one_number", "point 1 2"),
                    third("point_three_numbers", "point 1 2 3 4"), third("id_zero", "point 0 2 2"),
                    third("id_negative", "point -1 2 2"), third("id_fraction", "point 1.5 2 2"),
                    third("id_word", "point a 2 2"), third("id_two_to_the_63", "point 9223372036854775808 2 2"),
                    third("id_beyond_64_bits", "point 99999999999999999999999 2 2"),
                    third("remove_id_zero", "remove 0"), third("segment_three_numbers", "segment 1 2 2 3"),
                    third("segment_five_numbers", "segment 1 2 2 3 3 4"), third("polyline_no_count", "polyline 1"),
                    third("polyline_count_zero", "polyline 1 0"), third("polyline_count_negative", "polyline 1 -2 1 1"),
                    third("polyline_too_few", "polyline 1 3 1 1 2 2"), third("polyline_odd", "polyline 1 2 1 1 2"),
                    third("polyline_too_many", "polyline 1 2 1 1 2 2 3 3"),
                    third("polyline_second_ring", "polyline 1 2 1 1 2 2 / 2 3 3 4 4"),
                    third("polygon_no_ring", "polygon 1"), third("polygon_count_zero", "polygon 1 0"),
                    third("polygon_too_few", "polygon 1 3 1 1 2 2"),
                    third("polygon_too_many", "polygon 1 3 1 1 2 1 2 2 3 3"),
                    third("polygon_empty_ring", "polygon 1 3 1 1 2 1 2 2 /"),
                    third("polygon_slash_first", "polygon 1 / 3 1 1 2 1 2 2"),
                    third("polygon_two_slashes", "polygon 1 3 1 1 2 1 2 2 / / 3 1 1 2 1 2 2"),
                    third("polygon_short_second_ring", "polygon 1 3 1 1 2 1 2 2 / 3 1 1 2 1"),
                    third("polygon_huge_count", "polygon 1 18446744073709551615 1 1 2 1 2 2")),
    name_of);

TEST(MalformedScript, TheWholeScriptIsReadBeforeAnythingRuns) {
  const auto result = run_script("waywright 1\ndomain 0 0 10 10\nlocate 1 1\npoint 1 20 20\nlocate 2\n");
  expect_malformed(result, "-", 5);
}

TEST(MalformedScript, ADomainOutOfRangeIsReportedWithItsLine) {
  const TemporaryFolder folder;
  const auto result = run_command({"run", folder.file("a.wws", "waywright 1\n\ndomain 0 0 inf 1\nlocate 0 0\n")});
  expect_malformed(result, folder.file("a.wws"), 3);
}

/// A file of another format. The case contains the ending of its name.
struct MalformedMap {
  Malformed malformed;
  std::string file;
};

void PrintTo(const MalformedMap& map, std::ostream* out) { *out << map.malformed.name; }

class MalformedMapFile : public testing::TestWithParam<MalformedMap> {};

TEST_P(MalformedMapFile, EndsWithStatus2AndLeavesNothing) {
  const TemporaryFolder folder;
  const auto& [malformed, file] = GetParam();
  const std::string map = folder.file(file, malformed.text);
  expect_malformed(run_command({"path", map, "--from", "0", "0", "--to", "1", "1", "--svg", folder.file("o.svg")}), map,
                   malformed.line);
  expect_malformed(run_command({"convert", map, folder.file("out.wws")}), map, malformed.line);
  EXPECT_EQ(folder.file_count(), 1U);
}

INSTANTIATE_TEST_SUITE_P(
    All, MalformedMapFile,
    testing::Values(MalformedMap{{"map_empty", "", 1}, "a.map"},
                    MalformedMap{{"map_other_type", "type hex\nheight 1\nwidth 1\nmap\n.\n", 1}, "a.map"},
                    MalformedMap{{"map_height_word", "type octile\nheight one\nwidth 1\nmap\n.\n", 2}, "a.map"},
                    MalformedMap{{"map_width_zero", "type octile\nheight 1\nwidth 0\nmap\n\n", 3}, "a.map"},
                    MalformedMap{{"map_short_row", "type octile\nheight 2\nwidth 3\nmap\n...\n..\n", 6}, "a.map"},
                    MalformedMap{{"map_unknown_tile", "type octile\nheight 1\nwidth 3\nmap\n.x.\n", 5}, "a.map"},
                    MalformedMap{{"map_row_missing", "type octile\nheight 2\nwidth 1\nmap\n.\n", 5}, "a.map"},
                    MalformedMap{{"geojson_cut", "{\"type\":\n", 1}, "a.geojson"},
                    MalformedMap{{"json_of_another_program", "{\n\"a\":5}", 1}, "a.json"},
                    MalformedMap{{"geojson_height", "{\"type\":\"Point\",\n\"coordinates\":[1,2,3]}", 2}, "a.geojson"},
                    MalformedMap{{"wkt_empty", "", 1}, "a.wkt"},
                    MalformedMap{{"wkt_unclosed", "POINT(1 2)\nPOLYGON((0 0,1 0,1 1,0 1))", 2}, "a.wkt"},
                    MalformedMap{{"wkt_unknown", "\nCURVE(0 0,1 0)", 2}, "a.wkt"},
                    MalformedMap{{"mesh_cut", "mesh\n2\n3 1\n0 0 1 0\n", 4}, "a.mesh"},
                    MalformedMap{{"mesh_version", "mesh\n1\n3 1\n", 2}, "a.mesh"},
                    MalformedMap{{"obj_index", "v 0 0\nv 1 1\nl 1 3\n", 3}, "a.obj"},
                    MalformedMap{{"obj_face_of_one", "v 0 0\nf 1\n", 2}, "a.obj"},
                    MalformedMap{{"node_empty", "", 1}, "a.node"},
                    MalformedMap{{"node_three_dimensions", "1 3 0 0\n1 0 0 0\n", 1}, "a.node"},
                    MalformedMap{{"node_missing_vertex", "2 2 0 0\n1 0 0\n", 2}, "a.node"},
                    MalformedMap{{"node_word", "2 2 0 0\n1 0 0\n2 x 0\n", 3}, "a.node"},
                    MalformedMap{{"poly_no_segments", "1 2 0 0\n1 0 0\n", 2}, "a.poly"},
                    MalformedMap{{"poly_unknown_vertex", "2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1 3\n0\n", 5}, "a.poly"},
                    MalformedMap{{"poly_short_segment", "2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1\n0\n", 5}, "a.poly"}),
    [](const auto& param_info) { return param_info.param.malformed.name; });

}  // namespace
}  // namespace waywright::test
