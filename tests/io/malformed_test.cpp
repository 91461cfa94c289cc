#include <cstdint>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "waywright/scene.hpp"
#include "waywright/script.hpp"

namespace waywright {
namespace {

/// A text that its parser refuses, the line that the error must name, and how the message continues.
struct Malformed {
  std::string_view text;
  std::uint64_t line;
  std::string_view message;
};

constexpr std::string_view kName = "dir/some file.txt";

template <class T>
void expect_malformed(const Result<T>& result, const Malformed& expected) {
  ASSERT_FALSE(result.ok()) << expected.text;
  EXPECT_EQ(result.error().code, ErrorCode::malformed) << expected.text;
  EXPECT_EQ(result.error().index, expected.line) << expected.text;
  EXPECT_EQ(result.error().message(),
            std::string(kName) + ":" + std::to_string(expected.line) + ": " + std::string(expected.message))
      << expected.text;
}

constexpr Malformed kHeaders[] = {
    {"", 1, "expected the header 'waywright 1', found the end of the text"},
    {"\n# nothing\n\n", 3, "expected the header 'waywright 1', found the end of the text"},
    {"domain 0 0 1 1\n", 1, "expected the header 'waywright 1', found 'domain'"},
    {"# a\nwaywrong 1\n", 2, "expected the header 'waywright 1', found 'waywrong'"},
    {"Waywright 1\n", 1, "expected the header 'waywright 1', found 'Waywright'"},
    {"waywright1\n", 1, "expected the header 'waywright 1', found 'waywright1'"},
    {"waywright 1\n\xef\xbb\xbfwaywright 1\n", 2,
     "expected a word such as 'point' or 'path', found '\\xef\\xbb\\xbfwaywright'"},
    {"waywright\n", 1, "expected the format version in 'waywright 1', found the end of the line"},
    {"waywright # 1\n", 1, "expected the format version in 'waywright 1', found the end of the line"},
    {"waywright 2\n", 1, "expected format version 1 in 'waywright 1', found '2'"},
    {"waywright 1.0\n", 1, "expected format version 1 in 'waywright 1', found '1.0'"},
    {"waywright 1 1\n", 1, "expected the end of the line in 'waywright 1', found '1'"},
    {"waywright 1\n", 1, "expected 'domain X0 Y0 X1 Y1', found the end of the text"},
    {"waywright 1\n\n# end\n", 3, "expected 'domain X0 Y0 X1 Y1', found the end of the text"},
    {"waywright 1\npoint 1 0 0\n", 2, "expected 'domain X0 Y0 X1 Y1' before anything else, found 'point'"},
    {"waywright 1\nlocate 0 0\n", 2, "expected 'domain X0 Y0 X1 Y1' before anything else, found 'locate'"},
    {"waywright 1\ncheck\n", 2, "expected 'domain X0 Y0 X1 Y1' before anything else, found 'check'"},
    {"waywright 1\nwaywright 1\n", 2, "expected a word such as 'point' or 'path', found 'waywright'"},
    {"waywright 1\ndomain\n", 2, "expected a number in 'domain X0 Y0 X1 Y1', found the end of the line"},
    {"waywright 1\ndomain 0 0 1\n", 2, "expected a number in 'domain X0 Y0 X1 Y1', found the end of the line"},
    {"waywright 1\ndomain 0 0 1 1 1\n", 2, "expected the end of the line in 'domain X0 Y0 X1 Y1', found '1'"},
    {"waywright 1\ndomain 0 zero 1 1\n", 2, "expected a number in 'domain X0 Y0 X1 Y1', found 'zero'"},
    {"waywright 1\ndomain 1 0 1 1\n", 2, "expected a number above 1 in 'domain X0 Y0 X1 Y1', found '1'"},
    {"waywright 1\ndomain 0 2 1 -1.5\n", 2, "expected a number above 2 in 'domain X0 Y0 X1 Y1', found '-1.5'"},
    {"waywright 1\ndomain -0 0 0 1\n", 2, "expected a number above 0 in 'domain X0 Y0 X1 Y1', found '0'"},
    {"waywright 1\ndomain nan 0 1 1\n", 2,
     "expected X0 to be 0 or of a size from 2^-100 to 2^100 in 'domain X0 Y0 X1 Y1', found 'nan'"},
    {"waywright 1\ndomain 0 -inf 1 1\n", 2,
     "expected Y0 to be 0 or of a size from 2^-100 to 2^100 in 'domain X0 Y0 X1 Y1', found '-inf'"},
    {"waywright 1\ndomain 0 0 1e400 1\n", 2,
     "expected X1 to be 0 or of a size from 2^-100 to 2^100 in 'domain X0 Y0 X1 Y1', found '1e400'"},
    {"waywright 1\ndomain 0 0 1 1e-40\n", 2,
     "expected Y1 to be 0 or of a size from 2^-100 to 2^100 in 'domain X0 Y0 X1 Y1', found '1e-40'"},
};

TEST(MalformedScript, HeaderAndDomain) {
  for (const Malformed& each : kHeaders) expect_malformed(parse_script(each.text, kName), each);
}

/// Each of these is line 3, after a header and a domain.
constexpr Malformed kOperations[] = {
    {"domain 0 0 9 9", 3, "expected only one domain, found 'domain'"},
    {"foo", 3, "expected a word such as 'point' or 'path', found 'foo'"},
    {"POINT 1 0 0", 3, "expected a word such as 'point' or 'path', found 'POINT'"},
    {"1 2 3", 3, "expected a word such as 'point' or 'path', found '1'"},
    {"/", 3, "expected a word such as 'point' or 'path', found '/'"},
    {"mark", 3, "expected tick 1, the one after the last mark, in 'mark TICK', found the end of the line"},
    {"mark 0", 3, "expected tick 1, the one after the last mark, in 'mark TICK', found '0'"},
    {"mark 2", 3, "expected tick 1, the one after the last mark, in 'mark TICK', found '2'"},
    {"mark -1", 3, "expected tick 1, the one after the last mark, in 'mark TICK', found '-1'"},
    {"mark 18446744073709551617", 3,
     "expected tick 1, the one after the last mark, in 'mark TICK', found '18446744073709551617'"},
    {"mark 1 2", 3, "expected the end of the line in 'mark TICK', found '2'"},
    {"mark 1\nmark 1", 4, "expected tick 2, the one after the last mark, in 'mark TICK', found '1'"},
    {"mark 1\nmark 2\nrewind 1\nmark 3", 6, "expected tick 2, the one after the last mark, in 'mark TICK', found '3'"},
    {"rewind 1", 3, "expected a mark before in 'rewind TICK', found '1'"},
    {"rewind", 3, "expected a mark before in 'rewind TICK', found the end of the line"},
    {"mark 1\nrewind", 4, "expected a tick from 1 to 1, the last mark, in 'rewind TICK', found the end of the line"},
    {"mark 1\nrewind 0", 4, "expected a tick from 1 to 1, the last mark, in 'rewind TICK', found '0'"},
    {"mark 1\nrewind 2", 4, "expected a tick from 1 to 1, the last mark, in 'rewind TICK', found '2'"},
    {"mark 1\nrewind x", 4, "expected a tick from 1 to 1, the last mark, in 'rewind TICK', found 'x'"},
    {"mark 1\nmark 2\nrewind 1\nrewind 2", 6,
     "expected a tick from 1 to 1, the last mark, in 'rewind TICK', found '2'"},
    {"point", 3, "expected an id from 1 to 9223372036854775807 in 'point ID X Y', found the end of the line"},
    {"point 0 1 1", 3, "expected an id from 1 to 9223372036854775807 in 'point ID X Y', found '0'"},
    {"point -1 1 1", 3, "expected an id from 1 to 9223372036854775807 in 'point ID X Y', found '-1'"},
    {"point 1.0 1 1", 3, "expected an id from 1 to 9223372036854775807 in 'point ID X Y', found '1.0'"},
    {"point 9223372036854775808 1 1", 3,
     "expected an id from 1 to 9223372036854775807 in 'point ID X Y', found '9223372036854775808'"},
    {"point 99999999999999999999 1 1", 3,
     "expected an id from 1 to 9223372036854775807 in 'point ID X Y', found '99999999999999999999'"},
    {"point 1", 3, "expected a number in 'point ID X Y', found the end of the line"},
    {"point 1 2", 3, "expected a number in 'point ID X Y', found the end of the line"},
    {"point 1 2 # 3", 3, "expected a number in 'point ID X Y', found the end of the line"},
    {"point 1 2 3 4", 3, "expected the end of the line in 'point ID X Y', found '4'"},
    {"point 1 0x10 3", 3, "expected a number in 'point ID X Y', found '0x10'"},
    {"point 1 1,5 3", 3, "expected a number in 'point ID X Y', found '1,5'"},
    {"point 1 +-1 3", 3, "expected a number in 'point ID X Y', found '+-1'"},
    {"point 1 1e 3", 3, "expected a number in 'point ID X Y', found '1e'"},
    {"point 1 2 3\r4", 3, "expected a number in 'point ID X Y', found '3\\x0d4'"},
    {"point 1 2\v3", 3, "expected a number in 'point ID X Y', found '2\\x0b3'"},
    {"segment 1 0 0 1", 3, "expected a number in 'segment ID X1 Y1 X2 Y2', found the end of the line"},
    {"segment 1 0 0 1 1 1", 3, "expected the end of the line in 'segment ID X1 Y1 X2 Y2', found '1'"},
    {"polyline 1", 3,
     "expected a count of points, 1 or more, in 'polyline ID N X1 Y1 ... XN YN', found the end of the line"},
    {"polyline 1 0", 3, "expected a count of points, 1 or more, in 'polyline ID N X1 Y1 ... XN YN', found '0'"},
    {"polyline 1 -2 0 0 1 1", 3,
     "expected a count of points, 1 or more, in 'polyline ID N X1 Y1 ... XN YN', found '-2'"},
    {"polyline 1 2.5 0 0 1 1", 3,
     "expected a count of points, 1 or more, in 'polyline ID N X1 Y1 ... XN YN', found '2.5'"},
    {"polyline 1 2 0 0 1", 3, "expected a number in 'polyline ID N X1 Y1 ... XN YN', found the end of the line"},
    {"polyline 1 2 0 0 1 1 2 2", 3, "expected the end of the line in 'polyline ID N X1 Y1 ... XN YN', found '2'"},
    {"polyline 1 1 0 0 / 1 1 1", 3, "expected the end of the line in 'polyline ID N X1 Y1 ... XN YN', found '/'"},
    {"polyline 1 18446744073709551615 0 0", 3,
     "expected a number in 'polyline ID N X1 Y1 ... XN YN', found the end of the line"},
    {"polyline 1 18446744073709551616 0 0", 3,
     "expected a count of points, 1 or more, in 'polyline ID N X1 Y1 ... XN YN', found '18446744073709551616'"},
    {"polygon 1 0", 3,
     "expected a count of points, 1 or more, in 'polygon ID [nonzero] N X1 Y1 ... XN YN [/ N X1 Y1 ...]...', found "
     "'0'"},
    {"polygon 1 3 0 0 1 0 0", 3,
     "expected a number in 'polygon ID [nonzero] N X1 Y1 ... XN YN [/ N X1 Y1 ...]...', found the end of the line"},
    {"polygon 1 3 0 0 1 0 / 1 1 1", 3,
     "expected a number in 'polygon ID [nonzero] N X1 Y1 ... XN YN [/ N X1 Y1 ...]...', found '/'"},
    {"polygon 1 2 0 0 1 0 0 1", 3,
     "expected '/' or the end of the line in 'polygon ID [nonzero] N X1 Y1 ... XN YN [/ N X1 Y1 ...]...', found '0'"},
    {"polygon 1 1 0 0 /", 3,
     "expected a count of points, 1 or more, in 'polygon ID [nonzero] N X1 Y1 ... XN YN [/ N X1 Y1 ...]...', found the "
     "end of "
     "the line"},
    {"polygon 1 1 0 0 / / 1 0 0", 3,
     "expected a count of points, 1 or more, in 'polygon ID [nonzero] N X1 Y1 ... XN YN [/ N X1 Y1 ...]...', found "
     "'/'"},
    {"polygon 1 1 0 0/ 1 0 0", 3,
     "expected a number in 'polygon ID [nonzero] N X1 Y1 ... XN YN [/ N X1 Y1 ...]...', found '0/'"},
    {"polygon 1 / 1 0 0", 3,
     "expected a count of points, 1 or more, in 'polygon ID [nonzero] N X1 Y1 ... XN YN [/ N X1 Y1 ...]...', found "
     "'/'"},
    {"polygon 1 nonzero", 3,
     "expected a count of points, 1 or more, in 'polygon ID [nonzero] N X1 Y1 ... XN YN [/ N X1 Y1 ...]...', found "
     "the end of the line"},
    {"polygon 1 nonzero nonzero 1 0 0", 3,
     "expected a count of points, 1 or more, in 'polygon ID [nonzero] N X1 Y1 ... XN YN [/ N X1 Y1 ...]...', found "
     "'nonzero'"},
    {"polygon 1 even-odd 1 0 0", 3,
     "expected a count of points, 1 or more, in 'polygon ID [nonzero] N X1 Y1 ... XN YN [/ N X1 Y1 ...]...', found "
     "'even-odd'"},
    {"polygon nonzero 1 1 0 0", 3,
     "expected an id from 1 to 9223372036854775807 in 'polygon ID [nonzero] N X1 Y1 ... XN YN [/ N X1 Y1 ...]...', "
     "found 'nonzero'"},
    {"polyline 1 nonzero 1 0 0", 3,
     "expected a count of points, 1 or more, in 'polyline ID N X1 Y1 ... XN YN', found 'nonzero'"},
    {"remove", 3, "expected an id from 1 to 9223372036854775807 in 'remove ID', found the end of the line"},
    {"remove 0", 3, "expected an id from 1 to 9223372036854775807 in 'remove ID', found '0'"},
    {"remove 1 2", 3, "expected the end of the line in 'remove ID', found '2'"},
    {"replace", 3,
     "expected 'point', 'segment', 'polyline' or 'polygon' in 'replace KIND ID ...', found the end of the line"},
    {"replace 1", 3, "expected 'point', 'segment', 'polyline' or 'polygon' in 'replace KIND ID ...', found '1'"},
    {"replace remove 1", 3,
     "expected 'point', 'segment', 'polyline' or 'polygon' in 'replace KIND ID ...', found 'remove'"},
    {"replace replace point 1 1 1", 3,
     "expected 'point', 'segment', 'polyline' or 'polygon' in 'replace KIND ID ...', found 'replace'"},
    {"replace point 0 1 1", 3, "expected an id from 1 to 9223372036854775807 in 'point ID X Y', found '0'"},
    {"replace point 1 1", 3, "expected a number in 'point ID X Y', found the end of the line"},
    {"replace point 1 1 1 1", 3, "expected the end of the line in 'point ID X Y', found '1'"},
    {"locate 1", 3, "expected a number in 'locate X Y', found the end of the line"},
    {"locate 1 2 3", 3, "expected the end of the line in 'locate X Y', found '3'"},
    {"ray 1 2 3", 3, "expected a number in 'ray X1 Y1 X2 Y2 [RADIUS]', found the end of the line"},
    {"disc 1 2", 3, "expected a number in 'disc X Y RADIUS', found the end of the line"},
    {"disc 1 2 big", 3, "expected a number in 'disc X Y RADIUS', found 'big'"},
    {"nearest 1 2 3 4", 3, "expected 'goal' or the end of the line in 'nearest X Y RADIUS [goal X2 Y2]', found '4'"},
    {"nearest 1 2 3 goal 4", 3, "expected a number in 'nearest X Y RADIUS [goal X2 Y2]', found the end of the line"},
    {"path 1 2 3 4", 3,
     "expected a number in 'path X1 Y1 X2 Y2 RADIUS [ALGORITHM] [tolerance DISTANCE]', found the end of the line"},
    {"path 1 2 3 4 ta", 3,
     "expected a number in 'path X1 Y1 X2 Y2 RADIUS [ALGORITHM] [tolerance DISTANCE]', found 'ta'"},
    {"path 1 2 3 4 0 astar", 3,
     "expected 'optimal', 'ta', 'tra' or 'tolerance' in 'path X1 Y1 X2 Y2 RADIUS [ALGORITHM] [tolerance DISTANCE]', "
     "found 'astar'"},
    {"path 1 2 3 4 0 TA", 3,
     "expected 'optimal', 'ta', 'tra' or 'tolerance' in 'path X1 Y1 X2 Y2 RADIUS [ALGORITHM] [tolerance DISTANCE]', "
     "found 'TA'"},
    {"path 1 2 3 4 0 ta tra", 3,
     "expected 'tolerance' in 'path X1 Y1 X2 Y2 RADIUS [ALGORITHM] [tolerance DISTANCE]', found 'tra'"},
    {"check now", 3, "expected the end of the line in 'check', found 'now'"},
    {"hash 1", 3, "expected the end of the line in 'hash', found '1'"},
    {"check\n\n# x\nhash it\ncheck", 6, "expected the end of the line in 'hash', found 'it'"},
};

TEST(MalformedScript, Operations) {
  for (const Malformed& each : kOperations) {
    const std::string text = "waywright 1\ndomain 0 0 9 9\n" + std::string(each.text) + "\n";
    expect_malformed(parse_script(text, kName), each);
  }
}

TEST(MalformedScript, ANulByteBelongsToAWord) {
  using namespace std::string_view_literals;
  expect_malformed(parse_script("waywright 1\ndomain 0 0 9\0 9\n"sv, kName),
                   {"a NUL byte", 2, "expected a number in 'domain X0 Y0 X1 Y1', found '9\\x00'"});
}

constexpr Malformed kMaps[] = {
    {"", 1, "expected 'type octile', found the end of the text"},
    {"\ntype octile\n", 1, "expected 'type octile', found ''"},
    {"type tile\nheight 1\nwidth 1\nmap\n.\n", 1, "expected 'type octile', found 'type tile'"},
    {"type octile x\n", 1, "expected 'type octile', found 'type octile x'"},
    {"height 1\nwidth 1\nmap\n.\n", 1, "expected 'type octile', found 'height 1'"},
    {"type octile\n", 1, "expected 'height' and a number, 1 or more, found the end of the text"},
    {"type octile\nwidth 1\nheight 1\nmap\n.\n", 2, "expected 'height' and a number, 1 or more, found 'width 1'"},
    {"type octile\nheight\n", 2, "expected 'height' and a number, 1 or more, found 'height'"},
    {"type octile\nheight 0\n", 2, "expected 'height' and a number, 1 or more, found 'height 0'"},
    {"type octile\nheight -1\n", 2, "expected 'height' and a number, 1 or more, found 'height -1'"},
    {"type octile\nheight 1 1\n", 2, "expected 'height' and a number, 1 or more, found 'height 1 1'"},
    {"type octile\nheight 1\nwidth x\n", 3, "expected 'width' and a number, 1 or more, found 'width x'"},
    {"type octile\nheight 1\nwidth 99999999999999999999\n", 3,
     "expected 'width' and a number, 1 or more, found 'width 99999999999999999999'"},
    {"type octile\nheight 1\nwidth 1\n.\n", 4, "expected 'map', found '.'"},
    {"type octile\nheight 1\nwidth 1\nmap map\n.\n", 4, "expected 'map', found 'map map'"},
    {"type octile\nheight 1\nwidth 1\nmap\n", 4, "expected 1 rows, found the end of the text after 0"},
    {"type octile\nheight 3\nwidth 2\nmap\n..\n@@\n", 6, "expected 3 rows, found the end of the text after 2"},
    {"type octile\nheight 18446744073709551615\nwidth 2\nmap\n..\n", 5,
     "expected 18446744073709551615 rows, found the end of the text after 1"},
    {"type octile\nheight 2\nwidth 2\nmap\n..\n.\n", 6, "expected a row of 2 tiles, found 1"},
    {"type octile\nheight 2\nwidth 2\nmap\n...\n..\n", 5, "expected a row of 2 tiles, found 3"},
    {"type octile\nheight 2\nwidth 2\nmap\n\n..\n", 5, "expected a row of 2 tiles, found 0"},
    {"type octile\nheight 1\nwidth 18446744073709551615\nmap\n..\n", 5,
     "expected a row of 18446744073709551615 tiles, found 2"},
    {"type octile\nheight 1\nwidth 2\nmap\n.x\n", 5, "expected tiles out of '.GS@OTW', found 'x'"},
    {"type octile\nheight 1\nwidth 2\nmap\n.g\n", 5, "expected tiles out of '.GS@OTW', found 'g'"},
    {"type octile\nheight 1\nwidth 2\nmap\n.. \n", 5, "expected tiles out of '.GS@OTW', found ' '"},
    {"type octile\nheight 1\nwidth 2\nmap\n..\n\n..\n", 7, "expected the end of the text after 1 rows, found '..'"},
};

TEST(MalformedMap, Everything) {
  for (const Malformed& each : kMaps) expect_malformed(parse_movingai_map(each.text, kName), each);
}

constexpr Malformed kNodes[] = {
    {"", 1, "expected the number of vertices, found the end of the text"},
    {"# nothing\n\n", 2, "expected the number of vertices, found the end of the text"},
    {"x 2 0 0\n", 1, "expected the number of vertices, found 'x'"},
    {"-1 2 0 0\n", 1, "expected the number of vertices, found '-1'"},
    {"1 3 0 0\n1 0 0 0\n", 1, "expected dimension 2, found 3"},
    {"1 two\n", 1, "expected dimension 2, found 'two'"},
    {"1 2 -1 0\n", 1, "expected the number of attributes, found '-1'"},
    {"1 2 0 2\n1 0 0 0 0\n", 1, "expected 0 or 1 boundary markers, found 2"},
    {"1 2 0 0 0\n", 1, "expected the end of the line, found '0'"},
    {"1 2 0 0\n", 1, "expected vertex 0 or 1, found the end of the text"},
    {"2 2 0 0\n1 0 0\n", 2, "expected vertex 2, found the end of the text"},
    {"99999999999 2 0 0\n0 0 0\n", 2, "expected vertex 1, found the end of the text"},
    {"1 2 0 0\n2 0 0\n", 2, "expected vertex 0 or 1, found 2"},
    {"2 2 0 0\n1 0 0\n3 0 0\n", 3, "expected vertex 2, found 3"},
    {"2 2 0 0\n0 0 0\n2 0 0\n", 3, "expected vertex 1, found 2"},
    {"1 2 0 0\none 0 0\n", 2, "expected vertex 0 or 1, found 'one'"},
    {"1 2 0 0\n1 0\n", 2, "expected a coordinate, found the end of the line"},
    {"1 2 0 0\n1 0 y\n", 2, "expected a coordinate, found 'y'"},
    {"1 2 0 0\n1 0,0\n", 2, "expected a coordinate, found '0,0'"},
    {"1 2 0 0\n1 0 0 0\n", 2, "expected the end of the line, found '0'"},
    {"1 2 1 0\n1 0 0\n", 2, "expected an attribute, found the end of the line"},
    {"1 2 1 0\n1 0 0 a\n", 2, "expected an attribute, found 'a'"},
    {"1 2 18446744073709551615 0\n1 0 0 1\n", 2, "expected an attribute, found the end of the line"},
    {"1 2 0 1\n1 0 0\n", 2, "expected a boundary marker, found the end of the line"},
    {"1 2 0 0\n1 0 0\n2 0 0\n", 3, "expected the end of the text, found one more line"},
};

TEST(MalformedNode, Everything) {
  for (const Malformed& each : kNodes) expect_malformed(parse_triangle_node(each.text, kName), each);
}

/// Each of these follows three vertices, which are lines 1 to 4.
constexpr Malformed kPolys[] = {
    {"", 4, "expected the number of segments, found the end of the text"},
    {"many\n", 5, "expected the number of segments, found 'many'"},
    {"1 2\n", 5, "expected 0 or 1 boundary markers, found 2"},
    {"1 0 0\n", 5, "expected the end of the line, found '0'"},
    {"1 0\n", 5, "expected segment 0 or 1, found the end of the text"},
    {"99999999999 0\n1 1 2\n", 6, "expected segment 2, found the end of the text"},
    {"2 0\n1 1 2\n1 2 3\n0\n", 7, "expected segment 2, found 1"},
    {"1 0\n1 1\n0\n", 6, "expected the id of a vertex, found the end of the line"},
    {"1 0\n1 1 b\n0\n", 6, "expected the id of a vertex, found 'b'"},
    {"1 0\n1 0 1\n0\n", 6, "expected the id of a vertex, found 0, which no vertex has"},
    {"1 0\n1 1 4\n0\n", 6, "expected the id of a vertex, found 4, which no vertex has"},
    {"1 0\n1 1 18446744073709551615\n0\n", 6,
     "expected the id of a vertex, found 18446744073709551615, which no vertex has"},
    {"1 0\n1 1 2 7\n0\n", 6, "expected the end of the line, found '7'"},
    {"1 1\n1 1 2\n0\n", 6, "expected a boundary marker, found the end of the line"},
    {"1 0\n1 1 2\n", 6, "expected the number of holes, found the end of the text"},
    {"0\nnone\n", 6, "expected the number of holes, found 'none'"},
    {"0\n1 1\n", 6, "expected the end of the line, found '1'"},
    {"0\n1\n", 6, "expected hole 0 or 1, found the end of the text"},
    {"0\n1\n1 5\n", 7, "expected a coordinate, found the end of the line"},
    {"0\n1\n1 5 x\n", 7, "expected a coordinate, found 'x'"},
    {"0\n1\n1 5 5 5\n", 7, "expected the end of the line, found '5'"},
    {"0\n0\nsome\n", 7, "expected the number of regions, found 'some'"},
    {"0\n0\n1\n", 7, "expected region 0 or 1, found the end of the text"},
    {"0\n0\n1\n1 5 5\n", 8, "expected an attribute, found the end of the line"},
    {"0\n0\n1\n1 5 5 1 x\n", 8, "expected a largest area, found 'x'"},
    {"0\n0\n1\n1 5 5 1 1 1\n", 8, "expected the end of the line, found '1'"},
    {"0\n0\n0\n0\n", 8, "expected the end of the text, found one more line"},
};

TEST(MalformedPoly, Everything) {
  for (const Malformed& each : kPolys) {
    const std::string text = "3 2 0 0\n1 0 0\n2 8 0\n3 0 8\n" + std::string(each.text);
    expect_malformed(parse_triangle_poly(text, kName), each);
  }
}

TEST(MalformedPoly, NoVerticesAnywhere) {
  constexpr Malformed kExpected{"0 2 0 0\n0\n0\n", 1,
                                "expected vertices, here or in a .node file of the same name, found none"};
  expect_malformed(parse_triangle_poly(kExpected.text, kName), kExpected);
}

}  // namespace
}  // namespace waywright
