"""Pictures: matplotlib and SVG."""

import numpy as np
import pytest
import waywright
from xml.etree import ElementTree

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


def test_a_plot_shows_the_items_and_the_paths(world):
    world.insert_point((5, 5))
    figure, ax = pyplot.subplots()
    path = world.find_path((10, 45), (90, 45), agent=waywright.Agent(radius=5))
    assert world.plot(ax, mesh=True, paths=path, ids=True) is ax
    solids, walls = ax.collections[:2]
    assert len(solids.get_paths()) == 1 and len(walls.get_segments()) == 1
    assert walls.get_segments()[0].tolist() == [[20, 80], [80, 80]]
    lines = {tuple(line[0]) + tuple(line[-1]) for line in (each.get_xydata() for each in ax.lines) if len(line)}
    assert (10, 45, 90, 45) in lines
    assert sorted(text.get_text() for text in ax.texts) == ["1", "2", "3"]
    world.find_paths([(1, 1), (50, 50)], [(9, 9), (9, 9)]).plot(ax)
    figure.canvas.draw()
    pyplot.close(figure)


def test_holes_are_holes_in_a_plot():
    world = waywright.World((0, 0, 10, 10))
    world.insert_polygon([[(1, 1), (9, 1), (9, 9), (1, 9)], [(3, 3), (3, 7), (7, 7), (7, 3)]])
    figure, ax = pyplot.subplots()
    world.plot(ax)
    outline = ax.collections[0].get_paths()[0]
    assert len(outline.vertices) == 10
    pyplot.close(figure)


@pytest.mark.parametrize("fill", ["even-odd", "nonzero"])
def test_the_directions_of_rings_do_not_matter_for_even_odd(fill):
    """The colours of the picture, whatever the directions: a house with a court, in which there is a shed."""
    squares = [[(a, a), (10 - a, a), (10 - a, 10 - a), (a, 10 - a)] for a in (1, 3, 4)]
    for directions in [(1, 1, 1), (-1, 1, 1), (1, -1, 1), (-1, -1, -1)]:
        world = waywright.World((0, 0, 10, 10))
        world.insert_polygon([ring[::direction] for ring, direction in zip(squares, directions)], fill=fill)
        figure = pyplot.figure(figsize=(1, 1), dpi=100)
        ax = figure.add_axes((0, 0, 1, 1))
        world.plot(ax)
        figure.canvas.draw()
        picture = np.asarray(figure.canvas.buffer_rgba())[:, :, 0]
        for x, y in [(2, 5), (3.5, 5), (5, 5), (0.5, 0.5)]:
            is_solid = world.locate((x, y)).polygons == [1]
            assert (picture[99 - round(y * 10), round(x * 10)] < 250) == is_solid, (directions, x, y)
        pyplot.close(figure)


def test_svg(world):
    path = world.find_path((10, 45), (90, 45), agent=waywright.Agent(radius=5))
    svg = world.to_svg(
        [path, world.find_path((1, 1), (9, 9))],
        discs=[((10, 45), 5.0)],
        labels=[((10, 45), "start & <goal>")],
        polylines=[[(1, 1), (2, 2)]],
        title="A title",
        theme="light",
    )
    text = "".join(ElementTree.fromstring(svg).itertext())
    assert "A title" in text and "start & <goal>" in text
    assert world._repr_svg_().startswith("<svg")
    with pytest.raises(ValueError):
        world.to_svg(crop=(300, 300, 400, 400))
