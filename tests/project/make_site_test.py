"""What scripts/make_site.py gives to Doxygen, and what it finds wrong with a site."""

import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import make_site  # noqa: E402


class Headers(unittest.TestCase):
    def filtered(self, text):
        return make_site.filter_header(text, ROOT)

    def test_gives_labels_a_paragraph(self):
        self.assertIn("/// @par Cost\n/// O(1).\n", self.filtered("/// Cost: O(1).\n"))

    def test_leaves_labels_inside_a_sentence(self):
        self.assertIn("/// The Cost: O(1).\n", self.filtered("/// The Cost: O(1).\n"))

    def test_links_codes_of_errors(self):
        self.assertIn('@ref waywright::ErrorCode::bad_id "bad_id".', self.filtered("/// Errors: bad_id.\n"))
        self.assertNotIn("@ref", self.filtered("/// Returns bad_id.\n"))

    def test_finds_every_code_of_errors(self):
        codes = make_site.error_codes(ROOT)
        self.assertEqual([codes[0], codes[-1]], ["coordinate_range", "unwritable"])
        self.assertLessEqual({"bad_id", "too_large", "world_gone"}, set(codes))

    def test_links_pages(self):
        self.assertIn("[docs/paths.md](@ref docs_paths)", self.filtered("/// docs/paths.md says more.\n"))


class Pages(unittest.TestCase):
    def filtered(self, text, page="docs/guides/lockstep.md"):
        return make_site.filter_page(page, text, ROOT)

    def test_labels_headings(self):
        self.assertEqual(self.filtered("# Lockstep"), "# Lockstep {#docs_guides_lockstep}")
        self.assertEqual(self.filtered("## What `it` is, so"), "## What it is, so {#docs_guides_lockstep-what-it-is-so}")
        self.assertEqual(self.filtered("# Front", "README.md"), "# Front")

    def test_links_pages_and_headings(self):
        self.assertEqual(self.filtered("[a](../paths.md)"), "[a](@ref docs_paths)")
        self.assertEqual(self.filtered("[a](../cmake.md#options)"), "[a](@ref docs_cmake-options)")
        self.assertEqual(self.filtered("[a](#ids)"), "[a](@ref docs_guides_lockstep-ids)")
        self.assertEqual(self.filtered("[a](../../README.md)"), "[a](index.html)")
        self.assertEqual(self.filtered("[a](https://example.org)"), "[a](https://example.org)")

    def test_makes_pages_of_the_list_subpages_once(self):
        text = self.filtered("[a](paths.md) [b](paths.md)", "docs/README.md")
        self.assertEqual(text, '@subpage docs_paths "a" [b](@ref docs_paths)')

    def test_links_headers_examples_and_pictures(self):
        self.assertEqual(self.filtered("[a](../../include/waywright/world.hpp)"), "[a](@ref world.hpp)")
        self.assertEqual(self.filtered("[a](../../examples/small_rts.cpp)"), "[a](small_rts_8cpp-example.html)")
        self.assertEqual(self.filtered("![a](../images/demo.png)"), "![a](demo.png)")

    def test_makes_text_of_links_to_other_files(self):
        self.assertEqual(self.filtered("see [a](../../LICENSE)."), "see a.")

    def test_links_code_that_names_public_classes(self):
        self.assertEqual(self.filtered("`World::ray`"), '<code>@ref waywright::World::ray "World::ray"</code>')
        self.assertEqual(self.filtered("`Path::length`"), '<code>@ref waywright::Path "Path::length"</code>')
        self.assertEqual(self.filtered("`std::sort`"), "`std::sort`")

    def test_leaves_code_blocks(self):
        text = "```cpp\n# a\n[b](../paths.md) `World`\n```\n"
        self.assertEqual(self.filtered(text), text)


class Links(unittest.TestCase):
    def faults(self, link):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "a.html").write_text(f'<h1 id="top">A</h1><a href="{link}">b</a>', encoding="utf-8")
            return list(make_site.faults_of(Path(folder)))

    def test_accepts_links_that_lead_somewhere(self):
        for link in ("a.html", "#top", "a.html#top", "https://example.org"):
            self.assertEqual(self.faults(link), [])

    def test_refuses_links_that_lead_nowhere(self):
        self.assertEqual(self.faults("b.html"), ["a.html: the link to b.html leads nowhere"])
        self.assertEqual(self.faults("#end"), ["a.html: the link to #end leads to no place on that page"])


if __name__ == "__main__":
    unittest.main()
