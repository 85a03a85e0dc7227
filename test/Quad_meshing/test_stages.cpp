// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The stages of quadrangulate(), called one after the other, give its mesh, bit for bit; and meshes that need plans of
// default_grid_map_plans().

#undef NDEBUG
#include "quad_mesh_checks.h"
#include "test_cases.h"
#include "test_meshes.h"

#include <CGAL/Quad_meshing/Extraction/extract_quad_mesh.h>
#include <CGAL/Quad_meshing/Extraction/transfer_feature_edges.h>
#include <CGAL/Quad_meshing/Fields/cross_field.h>
#include <CGAL/Quad_meshing/Fields/curvature_directions.h>
#include <CGAL/Quad_meshing/Fields/feature_edges.h>
#include <CGAL/Quad_meshing/Guides/Guide_curve.h>
#include <CGAL/Quad_meshing/Layout/quads_of_t_mesh.h>
#include <CGAL/Quad_meshing/Layout/quantize_t_mesh.h>
#include <CGAL/Quad_meshing/Parameterization/Seamless_map.h>
#include <CGAL/Quad_meshing/Parameterization/integer_grid_map.h>
#include <CGAL/Quad_meshing/Parameterization/prepare_mesh.h>
#include <CGAL/Quad_meshing/Pipeline/Quadrangulation.h>
#include <CGAL/Quad_meshing/Pipeline/copy_components.h>
#include <CGAL/Quad_meshing/Pipeline/search_grid_map.h>
#include <CGAL/Quad_meshing/Pipeline/smoothing_directions.h>
#include <CGAL/Quad_meshing/Smoothing/smooth_quad_mesh.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace QM = CGAL::Quad_meshing;
namespace parameters = CGAL::parameters;

typedef test_meshes::Kernel Kernel;
typedef QM::Quadrangulation_mesh Mesh;
typedef QM::Quadrangulation_result Result;

namespace {

// What lies before the field.
struct Prepared
{
  Mesh::Property_map<Mesh::Face_index, std::optional<Kernel::Vector_3>> direction;
  Mesh::Property_map<Mesh::Face_index, double> weight;
  double releasable_length = 0;
};

Prepared prepare(QM::Quadrangulation_surface& s, double length)
{
  Prepared p;
  p.releasable_length = QM::detect_feature_edges(s.mesh, 40, length, s.is_feature).length;
  QM::split_for_alignment(s.mesh, s.mesh.points(), s.is_feature, true, s.origin, 1.5 * length);
  p.direction = s.mesh.add_property_map<Mesh::Face_index, std::optional<Kernel::Vector_3>>("f:direction").first;
  p.weight = s.mesh.add_property_map<Mesh::Face_index, double>("f:weight", 0).first;
  QM::curvature_directions(s.mesh, length, p.direction, p.weight, parameters::edge_is_constrained_map(s.is_feature));
  for(Mesh::Face_index f : s.mesh.faces())
    p.weight[f] *= 2; // as much as they count for quadrangulate()
  return p;
}

void smooth(QM::Quadrangulation_quads& q, const QM::Quadrangulation_surface& s, const Prepared& p)
{
  std::vector<double> weight;
  for(Mesh::Face_index f : s.mesh.faces())
    weight.push_back(p.weight[f]);
  const QM::Smoothing_directions d = QM::smoothing_directions(s, weight);
  const auto faces = get(boost::face_index, s.mesh);
  QM::smooth_quad_mesh(q.mesh, s.mesh, parameters::smooth_globally(true).edge_is_constrained_map(q.is_feature),
                       parameters::face_direction_map(boost::make_iterator_property_map(d.direction.begin(), faces))
                         .face_direction_weight_map(boost::make_iterator_property_map(d.weight.begin(), faces))
                         .face_sizing_map(s.length)
                         .edge_is_constrained_map(s.is_feature));
}

// A stage-by-stage quadrangulation: all components, each with the length of its edges and the number of its quads.
template <typename MakeQuads>
Mesh for_each_component(const Mesh& tm, double number_of_quads, const MakeQuads& make_quads)
{
  Mesh result;
  const QM::Component_copies components = QM::copy_components(tm);
  for(std::size_t i = 0; i < components.surfaces.size(); ++i)
  {
    QM::Quadrangulation_surface& s = *components.surfaces[i];
    const double length = components.edge_length_in(i, components.edge_length(number_of_quads));
    const Prepared p = prepare(s, length);
    result += make_quads(s, p, length, components.areas[i] / (length * length));
  }
  return result;
}

// With all plans.
Mesh by_stages(const Mesh& tm, double number_of_quads)
{
  return for_each_component(tm, number_of_quads,
                            [](QM::Quadrangulation_surface& s, const Prepared& p, double length, double quads)
                            {
                              const QM::Grid_map_search_result found =
                                QM::search_grid_map(s, p.direction, p.weight, { length, quads, p.releasable_length });
                              assert(found.is_valid() && found.figures.quads == found.quads->mesh.number_of_faces());
                              smooth(*found.quads, s, p);
                              return found.quads->mesh;
                            });
}

// With the first plan, function by function.
Mesh by_functions(const Mesh& tm, double number_of_quads)
{
  return for_each_component(
    tm, number_of_quads,
    [](QM::Quadrangulation_surface& s, const Prepared& p, double length, double quads)
    {
      for(Mesh::Face_index f : s.mesh.faces())
        s.length[f] = length;
      const auto np = parameters::target_edge_length(length).edge_is_constrained_map(s.is_feature);
      assert(QM::smooth_cross_field(s.mesh, s.angle, s.period_jump, s.index,
                                    parameters::target_edge_length(length)
                                      .face_direction_map(p.direction)
                                      .face_direction_weight_map(p.weight)
                                      .singularity_cost(QM::Quadrangulation_options().singularity_cost)
                                      .edge_is_constrained_map(s.is_feature))
               .is_valid());
      QM::Seamless_map map(s.mesh, s.angle, s.period_jump, s.index, np);
      QM::Quadrangulation_quads q;
      if(map.round_without_repair(s.mesh, std::sqrt(map.number_of_quads() / quads), s.uv).is_valid())
      {
        assert(QM::extract_quad_mesh(s.mesh, s.uv, q.mesh, parameters::face_location_map(q.location)).is_valid());
        QM::transfer_feature_edges(s.mesh, s.is_feature, q.mesh, q.location, q.is_feature);
      }
      else
      {
        const QM::T_mesh t = map.t_mesh();
        std::vector<int> lengths;
        assert(QM::quantize_t_mesh(t, lengths).is_valid);
        assert(
          QM::quads_of_t_mesh(t, lengths, s.mesh, q.mesh, q.is_feature, parameters::face_location_map(q.location)));
      }
      smooth(q, s, p);
      return q.mesh;
    });
}

// Compares the stages with the whole line; returns how many maps that took.
int compare(const std::string& name, const Mesh& tm, double number_of_quads)
{
  QM::Quadrangulation q(tm, tm.points()); // quadrangulate() copies its quads
  q.options.target_number_of_quads = number_of_quads;
  q.options.work_on_input = true; // as the stages do
  const Result r = q.run();
  const Mesh& whole = q.quads().mesh;
  std::cout << name << ": " << r.message << " " << r.quads << " quads, " << r.parameterization_attempts << " maps"
            << std::endl;
  assert(r.is_valid());
  assert(quad_mesh_checks::are_equal(whole, by_stages(tm, number_of_quads)));
  if(r.parameterization_attempts == static_cast<int>(r.components))
    assert(quad_mesh_checks::are_equal(whole, by_functions(tm, number_of_quads)));
  return r.parameterization_attempts;
}

Mesh mesh_of(const test_meshes::Soup& soup) { return test_meshes::make_mesh(soup); }

void test_stages()
{
  const test_meshes::Soup ball = test_meshes::perturbed(test_meshes::icosphere(3), 0.02, 1);
  assert(compare("cube", mesh_of(test_meshes::cube(7)), 600) == 1);
  compare("ball", mesh_of(ball), 400);
  compare("torus", mesh_of(test_meshes::torus(40, 20)), 700);
  compare("square with a hole", mesh_of(test_meshes::grid_with_hole(14, 14, 5, 9, 5, 9)), 500);
}

// Components share the length, but for those that are too small.
void test_components()
{
  const test_meshes::Soup ball = test_meshes::icosphere(3);
  auto small = [](const Kernel::Point_3& p) { return Kernel::Point_3(10 + p.x() / 30, p.y() / 30, p.z() / 30); };
  compare("two balls", mesh_of(test_meshes::joined(ball, test_meshes::mapped(ball, small))), 600);
}

void test_data()
{
  for(const auto& model : { std::make_pair("fandisk", 2000.), std::make_pair("elephant", 1500.) })
  {
    const std::string filename = CGAL::data_file_path(std::string("meshes/") + model.first + ".off");
    Mesh tm;
    if(std::ifstream(filename) && CGAL::IO::read_polygon_mesh(filename, tm))
      compare(model.first, tm, model.second);
    else
      std::cout << "no " << model.first << ".off: skipped" << std::endl;
  }
}

// A cone with n sides of two triangles, from the center of its bottom to its tip. Its sharp edges meet at the tip in
// narrow angles.
test_meshes::Soup sharp_cone(std::size_t n)
{
  test_meshes::Soup soup;
  soup.points = { Kernel::Point_3(0, 0, 1), Kernel::Point_3(0, 0, 0) };
  for(std::size_t i = 0; i < n; ++i)
  {
    const double angle = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(n);
    soup.points.emplace_back(std::cos(angle) * 0.5, std::sin(angle) * 0.5, 0);
  }
  for(std::size_t i = 0; i < n; ++i)
  {
    const std::size_t a = 2 + i, b = 2 + (i + 1) % n;
    soup.triangles.push_back({ { 0, a, b } });
    soup.triangles.push_back({ { 1, b, a } });
  }
  return soup;
}

struct Request
{
  double number_of_quads = 0, edge_length = 0;
  unsigned int seed = 0;
  bool align_boundary = true;
  std::vector<QM::Guide_curve> curves = {};
  bool work_on_input = true;
};

Result run(const Mesh& tm, const Request& request, const std::string& without, Mesh& quads)
{
  QM::Quadrangulation q(tm, tm.points());
  QM::Quadrangulation_options& o = q.options;
  o.target_number_of_quads = request.number_of_quads;
  o.target_edge_length = request.edge_length;
  o.random_seed = request.seed;
  o.align_boundary = request.align_boundary;
  o.feature_curves = request.curves;
  o.work_on_input = request.work_on_input;
  o.plans.erase(std::remove_if(o.plans.begin(), o.plans.end(),
                               [&](const QM::Grid_map_plan_rule& rule) { return rule.name == without; }),
                o.plans.end());
  assert(o.plans.size() + !without.empty() == QM::default_grid_map_plans().size());
  const Result r = q.run();
  quads = q.quads().mesh;
  return r;
}

// Without the plan there is no valid mesh, or one that follows less of the features, has a number of quads farther from
// the one asked for, or edges of a length farther from it.
void check_plan(const std::string& name, const Mesh& tm, const Request& request)
{
  Mesh quads;
  const Result with = run(tm, request, "", quads), without = run(tm, request, name, quads);
  auto print = [](const Result& r)
  {
    std::cout << QM::status_name(r.status) << ", " << r.quads << " quads, " << r.released_feature_share
              << " released, length " << r.target_edge_length;
  };
  std::cout << name << ": ";
  print(with);
  std::cout << "; without it ";
  print(without);
  std::cout << std::endl;
  assert(with.is_valid());
  auto deviation = [&](const Result& r)
  {
    return request.number_of_quads > 0 ? std::abs(std::log(static_cast<double>(r.quads) / request.number_of_quads))
                                       : std::abs(std::log(r.target_edge_length / request.edge_length));
  };
  assert(!without.is_valid() || without.released_feature_share > with.released_feature_share ||
         (without.released_feature_share == with.released_feature_share && deviation(without) > deviation(with)));
}

// A tube with two cells around has none that is a mesh. Where borders need not be aligned, there is no T-mesh to help.
void test_plans_for_coarse_grids()
{
  const Mesh tube = mesh_of(test_meshes::cylinder(40, 40, false, 1, 10));
  check_plan("finer", tube, { 0, 2 * CGAL_PI / 2.4, 0, false });
  check_plan("still finer", tube, { 0, 2 * CGAL_PI / 2.3, 0, false });
}

// A tube with room for two quads around gets three, as two would not be a mesh.
void test_narrow_tube()
{
  const Mesh tube = mesh_of(test_meshes::cylinder(40, 40, false, 1, 10));
  for(double around : { 2.4, 2., 1. })
  {
    QM::Quadrangulation q(tube, tube.points());
    q.options.target_edge_length = 2 * CGAL_PI / around;
    const QM::Quadrangulation_result r = q.run();
    std::cout << around << " around: " << r.message << " " << r.quads << " quads" << std::endl;
    assert(r.is_valid());
  }
}

// Eight curves that miss one point of a square by some 1e-5: they cut slivers there that no quads fit into.
void test_plan_of_released_curves()
{
  const int size = 20, lines = 8;
  const double middle = size / 2., reach = 8, turn = 0.1; // no line runs along the square
  Request request{ 300 };
  for(int i = 0; i < lines; ++i)
  {
    const double angle = CGAL_PI * i / lines + turn, c = std::cos(angle), s = std::sin(angle), miss = 1e-5 * (i - 3.5);
    const double x = middle - miss * s, y = middle + miss * c;
    QM::Guide_curve curve;
    curve.points = { Kernel::Point_3(x - reach * c, y - reach * s, 0),
                     Kernel::Point_3(x + reach * c, y + reach * s, 0) };
    request.curves.push_back(curve);
  }
  check_plan("release curves within 8", mesh_of(test_meshes::grid(size, size, size, size)), request);
}

// The field with few singularities makes long quads around a knob, and not as many as were asked for.
void test_plan_of_more_even_quads()
{
  Mesh knob;
  if(CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/dragknob.off"), knob))
    check_plan("more even quads", knob, { 300, 0, 0, true, {}, false });
  else
    std::cout << "no dragknob.off: skipped" << std::endl;
}

// The conical ends of drilled holes have few triangles: no vertex at their tips may have less than three quads.
void test_drilled_holes()
{
  Mesh drilled, quads;
  if(CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/oblong.off"), drilled))
    for(double n : { 500., 3000. })
    {
      Request request{ n };
      request.work_on_input = false;
      const Result r = run(drilled, request, "", quads);
      std::cout << "drilled holes: " << r.quads << " quads. " << r.message << std::endl;
      assert(r.is_valid());
    }
  else
    std::cout << "no oblong.off: skipped" << std::endl;
}

void test_plans_for_the_number()
{
  check_plan("nearer number", mesh_of(sharp_cone(5)), { 500 });
  check_plan("still nearer number", mesh_of(sharp_cone(5)), { 500 });
}

// The seed draws the length of "other length"; the same seed draws the same.
void test_random_seed()
{
  const Mesh cone = mesh_of(sharp_cone(6));
  Mesh first, again;
  assert(run(cone, { 150, 0, 1 }, "", first).is_valid());
  assert(run(cone, { 150, 0, 1 }, "", again).is_valid());
  assert(quad_mesh_checks::are_equal(first, again));

  QM::Grid_map_situation situation;
  situation.has_attempt = true;
  situation.folded_triangles = 3; // by the integers, as there were none before
  auto length = [&](unsigned int seed)
  {
    situation.random_seed = seed;
    for(const QM::Grid_map_plan_rule& rule : QM::default_grid_map_plans())
      if(rule.name == "other length")
        return rule.plan(situation).value().relative_length;
    return 0.;
  };
  assert(length(1) == length(1) && length(1) != length(2));
  for(unsigned int seed = 0; seed < 20; ++seed)
    assert(length(seed) >= 0.93 && length(seed) <= 1.05);
  situation.folded_triangles = 0;
  for(const QM::Grid_map_plan_rule& rule : QM::default_grid_map_plans())
    assert(rule.name != "other length" || !rule.plan(situation));
}

// Where the first map has folded triangles, weighting the energy anew changes it.
void test_stiffening_iterations()
{
  const QM::Component_copies components = QM::copy_components(mesh_of(sharp_cone(6)));
  QM::Quadrangulation_surface& s = *components.surfaces.front();
  const double length = components.edge_length(800);
  prepare(s, length);
  const auto np = parameters::target_edge_length(length).edge_is_constrained_map(s.is_feature);
  QM::smooth_cross_field(s.mesh, s.angle, s.period_jump, s.index, np);
  std::vector<std::vector<Kernel::Point_2>> maps;
  std::vector<std::size_t> folded;
  for(unsigned int n : { 0u, 5u })
  {
    const auto r = QM::integer_grid_map(
      s.mesh, s.angle, s.period_jump, s.index, s.uv,
      parameters::stiffening_iterations(n).target_edge_length(length).edge_is_constrained_map(s.is_feature));
    maps.emplace_back();
    for(Mesh::Halfedge_index h : s.mesh.halfedges())
      maps.back().push_back(s.uv[h]);
    folded.push_back(r.folded_faces.size());
  }
  std::cout << "folded triangles without and with stiffening: " << folded[0] << ", " << folded[1] << std::endl;
  assert(maps[0] != maps[1] && folded[0] > 0);
}

} // namespace

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "stages", test_stages },
                     { "components", test_components },
                     { "data", test_data },
                     { "plans_for_coarse_grids", test_plans_for_coarse_grids },
                     { "narrow_tube", test_narrow_tube },
                     { "plan_of_released_curves", test_plan_of_released_curves },
                     { "plan_of_more_even_quads", test_plan_of_more_even_quads },
                     { "drilled_holes", test_drilled_holes },
                     { "plans_for_the_number", test_plans_for_the_number },
                     { "random_seed", test_random_seed },
                     { "stiffening_iterations", test_stiffening_iterations } });
}
