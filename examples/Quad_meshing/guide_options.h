// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_EXAMPLES_GUIDE_OPTIONS_H
#define CGAL_QUAD_MESHING_EXAMPLES_GUIDE_OPTIONS_H

// The options of the program quadrangulate by which a user guides it: sizes, features, curves, strokes, irregular
// vertices and symmetry. Each option that names a file says what is wrong with it: file, line, reason.

#include "command_line.h"
#include "polyline_files.h"

#include <CGAL/Quad_meshing/IO/read_number_rows.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation.h>

#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace guide_options {

namespace QM = CGAL::Quad_meshing;
typedef QM::Quadrangulation Quadrangulation;
typedef Quadrangulation::Mesh Mesh;
typedef Quadrangulation::Kernel::Point_3 Point_3;
using command_line::read_lines;
using command_line::Unusable_input;

inline void add(po::options_description& options)
{
  options.add_options()("sizing", po::value<std::string>()->default_value("constant"),
                        "constant, curvature or features: what the length of edges adapts to")(
    "sizing-tolerance", po::value<double>(),
    "distance of the quads from the surface for --sizing curvature; instead of a number of quads")(
    "sizes", po::value<std::string>(),
    "lengths of edges: a number per face or per vertex of IN, discs 'x y z radius length', or a PLY file of IN with "
    "the "
    "vertex property edge_length")("min-edge-length", po::value<double>(), "smallest length of edges")(
    "max-edge-length", po::value<double>(), "largest length of edges")(
    "gradation", po::value<double>()->default_value(0.3, "0.3"), "largest slope of the length along the surface")(
    "features", po::value<std::string>(),
    "edges of IN that become chains of quad edges, instead of detected ones: pairs of vertex numbers, pairs of points, "
    "or an OBJ file with lines")(
    "curves", po::value<std::string>(),
    "polylines that become chains of quad edges: x y z in each line, an empty line between "
    "them, or an OBJ file with lines")("strokes", po::value<std::string>(),
                                       "polylines whose direction the quads follow, in the same formats")(
    "stroke-weight", po::value<double>()->default_value(QM::Guide_stroke().weight), "weight of the strokes")(
    "hard-strokes", "make the cross field follow the strokes exactly")(
    "singularities", po::value<std::string>(),
    "'x y z index' in each line: 1 for three quads at a vertex, -1 for five, 0 forbids an irregular vertex; "
    "'x y z 0 radius' forbids them in a region")("only-singularities",
                                                 "no irregular vertex inside of the surface but those of "
                                                 "--singularities")(
    "index-sums", po::value<std::string>(),
    "'x y z radius sum' in each line: the indices of the vertices in a region sum up to that")(
    "connect", po::value<std::string>(),
    "'x y z x y z' in each line: places of irregular vertices, or of features, that a straight chain of quad edges "
    "joins")("symmetry", po::value<std::vector<std::string>>()->composing(),
             "x, y, z, 'a,b,c,d' or auto: plane that the result is symmetric to; may be given up to three times")(
    "symmetry-tolerance", po::value<double>()->default_value(QM::Quadrangulation_options().symmetry_tolerance),
    "largest distance of IN from its mirror image, over the diagonal of its box");
}

// The mesh that was read and its relation to the file.
struct Input
{
  const Mesh& mesh;
  const std::string& filename;
  const QM::Mesh_reading_result& reading;
};

inline std::string place(const std::string& filename, std::size_t line)
{
  return filename + ": Line " + std::to_string(line);
}

inline std::vector<QM::Number_row> read_rows(const std::string& filename)
{
  std::vector<QM::Number_row> rows;
  const QM::Guide_reading_result result = QM::read_number_rows(filename, rows);
  if(!result.is_valid())
    throw Unusable_input(filename + ": " + result.message);
  return rows;
}

inline Point_3 point(const std::vector<double>& n) { return Point_3(n[0], n[1], n[2]); }
inline Point_3 point(const std::array<double, 3>& n) { return Point_3(n[0], n[1], n[2]); }

template <typename Curve>
Curve read_curve(const std::string& filename, const QM::File_polyline& line)
{
  Curve c;
  for(const auto& p : line.points)
    c.points.push_back(point(p));
  c.is_closed = line.is_closed;
  c.name = "the polyline in line " + std::to_string(line.line) + " of " + filename;
  if(c.points.size() < 2)
    throw Unusable_input(place(filename, line.line) + ": a polyline has less than two points.");
  return c;
}

// Numbers of a file, one per element of the input, brought to the elements of the mesh.
template <typename Index>
std::map<Index, double> of_elements(const std::vector<double>& of_file, const QM::File_numbers& numbers)
{
  std::map<Index, double> result;
  for(std::size_t i = 0; i < numbers.mesh_size(); ++i)
  {
    const std::size_t n = numbers.file_number(i);
    result[Index(static_cast<Mesh::size_type>(i))] = n < of_file.size() ? of_file[n] : 0;
  }
  return result;
}

inline void read_ply_lengths(const std::string& filename, const Input& in, Quadrangulation& q)
{
  std::ifstream file(filename, std::ios::in | std::ios::binary);
  Mesh colored;
  std::string comments;
  if(!file || !CGAL::IO::read_PLY(file, colored, comments))
    throw Unusable_input(filename + ": The file cannot be read as a mesh in PLY format.");
  std::vector<double> lengths;
  auto read = [&](auto zero)
  {
    const auto map = colored.add_property_map<Mesh::Vertex_index, decltype(zero)>("v:edge_length", zero);
    if(map.second) // it is new
      return false;
    for(Mesh::Vertex_index v : colored.vertices())
      lengths.push_back(static_cast<double>(map.first[v]));
    return true;
  };
  if(!read(double(0)) && !read(float(0)))
    throw Unusable_input(filename + ": The vertices have no property edge_length of type double or float.");
  if(lengths.size() != in.reading.vertices.file_size())
    throw Unusable_input(filename + ": The file has " + std::to_string(lengths.size()) + " vertices, but " +
                         in.filename + " has " + std::to_string(in.reading.vertices.file_size()) + ".");
  const auto map = of_elements<Mesh::Vertex_index>(lengths, in.reading.vertices);
  q.set_vertex_lengths(in.mesh, boost::make_assoc_property_map(map));
}

inline void read_sizes(const std::string& filename, const Input& in, Quadrangulation& q)
{
  if(QM::internal::file_extension(filename) == "ply")
    return read_ply_lengths(filename, in, q);
  const std::vector<QM::Number_row> rows = read_rows(filename);
  const std::size_t n = rows.front().numbers.size(), numbers_of_a_disc = 5;
  if(n != 1 && n != numbers_of_a_disc)
    throw Unusable_input(place(filename, rows.front().line) + ": a line has one number or five (x y z radius length).");
  std::vector<double> lengths;
  for(const QM::Number_row& row : rows)
  {
    if(row.numbers.size() != n)
      throw Unusable_input(place(filename, row.line) + ": the line has " + std::to_string(row.numbers.size()) +
                           " numbers, those before have " + std::to_string(n) + ".");
    if(n == 1)
    {
      if(row.numbers[0] < 0)
        throw Unusable_input(place(filename, row.line) + ": a length is negative.");
      lengths.push_back(row.numbers[0]);
      continue;
    }
    QM::Size_disc disc;
    disc.center = point(row.numbers);
    disc.radius = row.numbers[3];
    disc.length = row.numbers[4];
    disc.name = "the disc in line " + std::to_string(row.line) + " of " + filename;
    if(!(disc.radius > 0) || !(disc.length > 0))
      throw Unusable_input(place(filename, row.line) + ": the radius or the length is not positive.");
    q.options.size_discs.push_back(disc);
  }
  if(n != 1)
    return;
  if(lengths.size() == in.reading.faces.file_size())
  {
    const auto map = of_elements<Mesh::Face_index>(lengths, in.reading.faces);
    q.set_face_lengths(in.mesh, boost::make_assoc_property_map(map));
  }
  else if(lengths.size() == in.reading.vertices.file_size())
  {
    const auto map = of_elements<Mesh::Vertex_index>(lengths, in.reading.vertices);
    q.set_vertex_lengths(in.mesh, boost::make_assoc_property_map(map));
  }
  else
    throw Unusable_input(filename + ": There are " + std::to_string(lengths.size()) + " lengths, but " + in.filename +
                         " has " + std::to_string(in.reading.faces.file_size()) + " faces and " +
                         std::to_string(in.reading.vertices.file_size()) + " vertices.");
}

// Finds edges of the input by their ends.
class Edge_finder
{
  typedef std::pair<Point_3, Mesh::Vertex_index> Sample;
  typedef CGAL::Search_traits_adapter<Sample, CGAL::First_of_pair_property_map<Sample>,
                                      CGAL::Search_traits_3<Quadrangulation::Kernel>>
    Traits;
  typedef CGAL::Orthogonal_k_neighbor_search<Traits> Search;

public:
  explicit Edge_finder(const Input& in) : m_in(in)
  {
    CGAL::Bbox_3 box;
    for(Mesh::Vertex_index v : in.mesh.vertices())
    {
      m_tree.insert(Sample(in.mesh.point(v), v));
      box += in.mesh.point(v).bbox();
    }
    m_diagonal = std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span()));
  }

  // The vertices at a point, within a millionth of the diagonal.
  std::vector<Mesh::Vertex_index> at(const Point_3& p) const
  {
    const double tolerance = 1e-6 * m_diagonal;
    const unsigned int most = 8; // that repairs leave at one place
    std::vector<Mesh::Vertex_index> result;
    const Search search(m_tree, p, most);
    for(const auto& s : search)
      if(s.second <= tolerance * tolerance)
        result.push_back(s.first.second);
    return result;
  }

  // The vertices of a number of the file.
  std::vector<Mesh::Vertex_index> number(double x) const
  {
    std::vector<Mesh::Vertex_index> result;
    for(std::size_t i = 0; i < m_in.reading.vertices.mesh_size(); ++i)
      if(static_cast<double>(m_in.reading.vertices.file_number(i)) == x)
        result.push_back(Mesh::Vertex_index(static_cast<Mesh::size_type>(i)));
    return result;
  }

  // Marks the edges between two vertices; returns whether there is one.
  bool mark(const std::vector<Mesh::Vertex_index>& a, const std::vector<Mesh::Vertex_index>& b,
            std::map<Mesh::Edge_index, bool>& marks) const
  {
    bool found = false;
    for(Mesh::Vertex_index v : a)
      for(Mesh::Vertex_index w : b)
        if(const Mesh::Halfedge_index h = m_in.mesh.halfedge(v, w); h != Mesh::null_halfedge())
          marks[m_in.mesh.edge(h)] = found = true;
    return found;
  }

private:
  const Input& m_in;
  typename Search::Tree m_tree;
  double m_diagonal;
};

inline void read_features(const std::string& filename, const Input& in, Quadrangulation& q)
{
  const Edge_finder find(in);
  std::map<Mesh::Edge_index, bool> marks;
  for(Mesh::Edge_index e : in.mesh.edges())
    marks[e] = false;
  auto add = [&](std::size_t line, const std::vector<Mesh::Vertex_index>& a, const std::vector<Mesh::Vertex_index>& b)
  {
    if(a.empty() || b.empty())
      throw Unusable_input(place(filename, line) + ": " + in.filename + " has no such vertex.");
    if(!find.mark(a, b, marks))
      throw Unusable_input(place(filename, line) + ": " + in.filename +
                           " has no edge between the two vertices; --curves takes lines that are no edges.");
  };
  if(QM::internal::file_extension(filename) == "obj")
    for(const QM::File_polyline& l : read_lines(filename))
      for(std::size_t i = 0; i + (l.is_closed ? 0 : 1) < l.points.size(); ++i)
        add(l.line, find.at(point(l.points[i])), find.at(point(l.points[(i + 1) % l.points.size()])));
  else
    for(const QM::Number_row& row : read_rows(filename))
    {
      const std::vector<double>& n = row.numbers;
      if(n.size() == 2)
        add(row.line, find.number(n[0]), find.number(n[1]));
      else if(n.size() == 6)
        add(row.line, find.at(point(n)), find.at(Point_3(n[3], n[4], n[5])));
      else
        throw Unusable_input(place(filename, row.line) + ": a line has two vertex numbers or six coordinates, not " +
                             std::to_string(n.size()) + " numbers.");
    }
  q.set_feature_edges(in.mesh, boost::make_assoc_property_map(marks));
}

inline void read_singularities(const std::string& filename, Quadrangulation& q)
{
  for(const QM::Number_row& row : read_rows(filename))
  {
    const std::vector<double>& n = row.numbers;
    if(n.size() != 4 && n.size() != 5)
      throw Unusable_input(place(filename, row.line) +
                           ": a line has four numbers (x y z index) or five (x y z 0 radius).");
    QM::Index_guide g;
    g.point = point(n);
    g.index = static_cast<int>(n[3]);
    g.radius = n.size() == 5 ? n[4] : 0;
    g.name = "line " + std::to_string(row.line) + " of " + filename;
    const double largest = 3, smallest = -100;
    if(n[3] != g.index || !(n[3] <= largest && n[3] >= smallest))
      throw Unusable_input(place(filename, row.line) + ": the index is not a whole number of at most 3.");
    if(g.radius < 0 || (g.radius > 0 && g.index != 0))
      throw Unusable_input(place(filename, row.line) +
                           ": a radius is not negative, and stands behind an index of 0 only.");
    q.options.index_guides.push_back(g);
  }
}

inline void read_index_sums(const std::string& filename, Quadrangulation& q)
{
  for(const QM::Number_row& row : read_rows(filename))
  {
    const std::vector<double>& n = row.numbers;
    if(n.size() != 5)
      throw Unusable_input(place(filename, row.line) + ": a line has five numbers (x y z radius sum).");
    QM::Index_guide g;
    g.point = point(n);
    g.radius = n[3];
    g.index = static_cast<int>(n[4]);
    g.is_sum = true;
    g.name = "line " + std::to_string(row.line) + " of " + filename;
    if(!(g.radius > 0))
      throw Unusable_input(place(filename, row.line) + ": the radius is not positive.");
    const double most = 1e6; // irregular vertices that anybody could mean
    if(!(std::abs(n[4]) <= most) || n[4] != g.index)
      throw Unusable_input(place(filename, row.line) + ": the sum is not a whole number.");
    q.options.index_guides.push_back(g);
  }
}

inline void read_connections(const std::string& filename, Quadrangulation& q)
{
  for(const QM::Number_row& row : read_rows(filename))
  {
    const std::vector<double>& n = row.numbers;
    if(n.size() != 6)
      throw Unusable_input(place(filename, row.line) + ": a line has six numbers (x y z x y z).");
    QM::Guide_connection c;
    c.from = point(n);
    c.to = Point_3(n[3], n[4], n[5]);
    c.name = "line " + std::to_string(row.line) + " of " + filename;
    q.options.connections.push_back(c);
  }
}

// One guide for each component: a point of it, and an infinite radius.
inline void forbid_other_singularities(const Mesh& mesh, Quadrangulation& q)
{
  std::map<Mesh::Face_index, std::size_t> component;
  const std::size_t n =
    CGAL::Polygon_mesh_processing::connected_components(mesh, boost::make_assoc_property_map(component));
  std::vector<char> is_done(n, 0);
  for(Mesh::Face_index f : mesh.faces())
  {
    if(is_done[component[f]])
      continue;
    is_done[component[f]] = 1;
    QM::Index_guide g;
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    g.point =
      CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))));
    g.radius = std::numeric_limits<double>::infinity();
    g.name = "--only-singularities";
    q.options.index_guides.push_back(g);
  }
}

inline QM::Symmetry_plane read_plane(const std::string& text)
{
  if(text == "auto")
    return QM::Symmetry_plane();
  for(int c = 0; c < 3; ++c)
    if(text == std::string(1, "xyz"[c]))
      return QM::Symmetry_plane::with_normal(c == 0, c == 1, c == 2);
  std::istringstream in(text);
  std::array<double, 4> n;
  char comma = ',';
  for(int i = 0; i < 4; ++i)
    if((i > 0 && !(in >> comma)) || comma != ',' || !(in >> n[i]) || !std::isfinite(n[i]))
      throw Unusable_input("--symmetry must be x, y, z, auto or a,b,c,d, not '" + text + "'");
  if(in >> comma || n[0] * n[0] + n[1] * n[1] + n[2] * n[2] == 0)
    throw Unusable_input("--symmetry must be x, y, z, auto or a,b,c,d with a normal a,b,c that is not zero, not '" +
                         text + "'");
  return QM::Symmetry_plane::with_equation(n[0], n[1], n[2], n[3]);
}

// Gives a quadrangulation what the options say.
inline void read(const command_line::Arguments& args, const Input& in, Quadrangulation& q)
{
  QM::Quadrangulation_options& o = q.options;
  const QM::Sizing_method methods[] = { QM::Sizing_method::CONSTANT, QM::Sizing_method::CURVATURE,
                                        QM::Sizing_method::FEATURE_SIZE };
  o.sizing_method = methods[args.choice("sizing", { "constant", "curvature", "features" })];
  o.sizing_gradation = args.positive_number("gradation");
  for(const auto& option : { std::make_pair("sizing-tolerance", &o.sizing_tolerance),
                             std::make_pair("min-edge-length", &o.smallest_edge_length),
                             std::make_pair("max-edge-length", &o.largest_edge_length) })
    if(args.has(option.first))
      *option.second = args.positive_number(option.first);
  if(args.has("sizing-tolerance") && o.sizing_method != QM::Sizing_method::CURVATURE)
    throw Unusable_input("--sizing-tolerance stands with --sizing curvature only");
  if(args.has("sizes"))
    read_sizes(args.value<std::string>("sizes"), in, q);
  if(args.has("features"))
    read_features(args.value<std::string>("features"), in, q);
  if(args.has("curves"))
    for(const QM::File_polyline& l : read_lines(args.value<std::string>("curves")))
      o.feature_curves.push_back(read_curve<QM::Guide_curve>(args.value<std::string>("curves"), l));
  const double weight =
    args.has("hard-strokes") ? std::numeric_limits<double>::infinity() : args.positive_number("stroke-weight");
  if(args.has("strokes"))
    for(const QM::File_polyline& l : read_lines(args.value<std::string>("strokes")))
    {
      o.strokes.push_back(read_curve<QM::Guide_stroke>(args.value<std::string>("strokes"), l));
      o.strokes.back().weight = weight;
    }
  if(args.has("singularities"))
    read_singularities(args.value<std::string>("singularities"), q);
  if(args.has("only-singularities"))
    forbid_other_singularities(in.mesh, q);
  if(args.has("index-sums"))
    read_index_sums(args.value<std::string>("index-sums"), q);
  if(args.has("connect"))
    read_connections(args.value<std::string>("connect"), q);
  if(args.has("symmetry"))
    for(const std::string& text : args.value<std::vector<std::string>>("symmetry"))
      o.symmetry_planes.push_back(read_plane(text));
  o.symmetry_tolerance = args.positive_number("symmetry-tolerance");
}

} // namespace guide_options

#endif // CGAL_QUAD_MESHING_EXAMPLES_GUIDE_OPTIONS_H
