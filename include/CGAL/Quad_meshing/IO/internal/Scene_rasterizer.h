// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_SCENE_RASTERIZER_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_SCENE_RASTERIZER_H

#include <CGAL/Quad_meshing/IO/Scene.h>
#include <CGAL/Quad_meshing/IO/internal/Png_encoder.h>
#include <CGAL/Quad_meshing/IO/internal/Scene_colors.h>
#include <CGAL/Quad_meshing/IO/internal/write_scene_json.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Draws the visible layers of a scene as a page does at first, with the same light and colors and from the same side,
// but so that they fill the picture. The depth of every pixel decides what hides what; there are four samples for each
// pixel.
class Scene_rasterizer
{
  typedef Simple_cartesian<double>::Vector_3 Vector_3;

  static constexpr int samples = 2; // per pixel, across and down
  // Of the distance of the faces that they lie in: sides of faces, and lines and points, which may lie on sides.
  static constexpr double nearer_sides = 0.997;
  static constexpr double nearer_marks = 0.9965;
  static constexpr double radius_of_points = 4.5; // in pixels
  static constexpr double width_of_lines = 1;     // in pixels

  // A point as the eye sees it: place in samples, distance from the eye.
  struct Seen
  {
    double x, y, depth;
  };

  const int m_width, m_height; // in samples
  std::vector<double> m_depth;
  std::vector<Scene_color> m_color;
  Vector_3 m_right, m_up, m_back;
  double m_distance;
  double m_scale = 1, m_x = 0, m_y = 0; // of a picture at distance 1: samples per unit, place of its origin

public:
  Scene_rasterizer(int width, int height)
    : m_width(samples * width)
    , m_height(samples * height)
    , m_depth(static_cast<std::size_t>(m_width) * m_height, (std::numeric_limits<double>::infinity)())
    , m_color(m_depth.size(), Scene_color{ { 1, 1, 1 } })
  {
    // as resetView() of view.js
    const double half_angle = 35 * CGAL_PI / 360;
    m_back = Vector_3(0.55, 0.45, 0.75);
    m_back = m_back / std::sqrt(m_back.squared_length());
    m_right = cross_product(Vector_3(0, 1, 0), m_back);
    m_right = m_right / std::sqrt(m_right.squared_length());
    m_up = cross_product(m_back, m_right);
    m_distance = 1.1 / std::sin(half_angle);
  }

  void draw(const Scene& scene, Scene_side side)
  {
    const Scene_box box(scene);
    std::vector<const Scene_layer*> layers;
    std::vector<std::vector<Vector_3>> points;
    for(const Scene_layer& layer : scene.layers)
      if(layer.is_visible && (layer.side == Scene_side::BOTH || side == Scene_side::BOTH || layer.side == side))
      {
        layers.push_back(&layer);
        points.push_back(scaled_points(layer, box));
      }
    fit(points);
    for(std::size_t i = 0; i < layers.size(); ++i)
      draw(*layers[i], points[i]);
  }

  std::vector<Png_encoder::Pixel> pixels() const
  {
    std::vector<Png_encoder::Pixel> out;
    for(int y = 0; y < m_height; y += samples)
      for(int x = 0; x < m_width; x += samples)
      {
        Png_encoder::Pixel pixel;
        for(std::size_t k = 0; k < 3; ++k)
        {
          double sum = 0;
          for(int j = 0; j < samples; ++j)
            for(int i = 0; i < samples; ++i)
              sum += m_color[index(x + i, y + j)][k];
          pixel[k] = static_cast<unsigned char>(std::lround(255 * sum / (samples * samples)));
        }
        out.push_back(pixel);
      }
    return out;
  }

private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * m_width + x; }

  static std::vector<Vector_3> scaled_points(const Scene_layer& layer, const Scene_box& box)
  {
    std::vector<Vector_3> points;
    for(const std::array<double, 3>& p : layer.points)
      points.emplace_back((p[0] - box.center(0)) / box.radius(), (p[1] - box.center(1)) / box.radius(),
                          (p[2] - box.center(2)) / box.radius());
    return points;
  }

  // Makes the points fill the picture but for a margin.
  void fit(const std::vector<std::vector<Vector_3>>& points)
  {
    constexpr double filled_share = 0.94;
    const double infinity = (std::numeric_limits<double>::infinity)();
    double low_x = infinity, high_x = -infinity, low_y = infinity, high_y = -infinity;
    for(const std::vector<Vector_3>& of_layer : points)
      for(const Vector_3& p : of_layer)
      {
        const Seen s = seen(p);
        low_x = (std::min)(low_x, s.x);
        high_x = (std::max)(high_x, s.x);
        low_y = (std::min)(low_y, s.y);
        high_y = (std::max)(high_y, s.y);
      }
    if(!(low_x <= high_x))
      return;
    // a single point has no size
    const double smallest_size = 1e-9;
    m_scale = filled_share * (std::min)(m_width / (std::max)(high_x - low_x, smallest_size),
                                        m_height / (std::max)(high_y - low_y, smallest_size));
    m_x = m_width / 2. - m_scale * (low_x + high_x) / 2;
    m_y = m_height / 2. - m_scale * (low_y + high_y) / 2;
  }

  void draw(const Scene_layer& layer, const std::vector<Vector_3>& points)
  {
    const Scene_colors color(layer);
    for(std::size_t e = 0; e < layer.size(); ++e)
    {
      const std::size_t begin = layer.first_corner[e], end = layer.first_corner[e + 1];
      if(layer.kind == Scene_layer_kind::FACES)
        draw_face(layer, points, e, color(e));
      else if(layer.kind == Scene_layer_kind::LINES)
        for(std::size_t c = begin; c + 1 < end; ++c)
          draw_line(points[layer.corners[c]], points[layer.corners[c + 1]], color(e), nearer_marks);
      else
        draw_point(points[layer.corners[begin]], color(e));
    }
  }

  Seen seen(const Vector_3& p, double share = 1) const
  {
    const double depth = m_distance - p * m_back;
    return { m_x + m_scale * (p * m_right) / depth, m_y - m_scale * (p * m_up) / depth, share * depth };
  }

  void put(int x, int y, double depth, const Scene_color& color)
  {
    if(x < 0 || y < 0 || x >= m_width || y >= m_height || depth >= m_depth[index(x, y)])
      return;
    m_depth[index(x, y)] = depth;
    m_color[index(x, y)] = color;
  }

  void draw_face(const Scene_layer& layer, const std::vector<Vector_3>& points, std::size_t e, Scene_color color)
  {
    const std::size_t begin = layer.first_corner[e], end = layer.first_corner[e + 1];
    Vector_3 normal(0, 0, 0), center(0, 0, 0);
    for(std::size_t c = begin; c < end; ++c)
    {
      const Vector_3 &p = points[layer.corners[c]], &q = points[layer.corners[c + 1 < end ? c + 1 : begin]];
      normal = normal + cross_product(p, q);
      center = center + p / static_cast<double>(end - begin);
    }
    const Vector_3 to_eye = m_distance * m_back - center;
    const double length = std::sqrt(normal.squared_length() * to_eye.squared_length());
    const double cosine = length > 0 ? normal * to_eye / length : 0;
    for(double& c : color)
      c *= (0.35 + 0.65 * std::abs(cosine)) * (cosine < 0 ? 0.7 : 1);
    for(std::size_t c = begin + 1; c + 1 < end; ++c)
      fill(
        { { seen(points[layer.corners[begin]]), seen(points[layer.corners[c]]), seen(points[layer.corners[c + 1]]) } },
        layer.grid.empty() ? nullptr : &layer.grid, { { begin, c, c + 1 } }, color);
    if(layer.has_sides)
      for(std::size_t c = begin; c < end; ++c)
        draw_line(points[layer.corners[c]], points[layer.corners[c + 1 < end ? c + 1 : begin]],
                  { { 0.15, 0.15, 0.15 } }, nearer_sides);
  }

  // Numbers that are linear on the triangle are, over the distance, linear on the picture.
  void fill(const std::array<Seen, 3>& t, const std::vector<std::array<double, 2>>* grid,
            const std::array<std::size_t, 3>& corners, const Scene_color& color)
  {
    const double area = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x);
    if(area == 0)
      return;
    const auto limits = [&](double a, double b, double c, int most)
    {
      return std::array<int, 2>{ { static_cast<int>((std::max)(0., std::floor((std::min)({ a, b, c })))),
                                   static_cast<int>((std::min)(most - 1., std::ceil((std::max)({ a, b, c })))) } };
    };
    const std::array<int, 2> xs = limits(t[0].x, t[1].x, t[2].x, m_width),
                             ys = limits(t[0].y, t[1].y, t[2].y, m_height);
    for(int y = ys[0]; y <= ys[1]; ++y)
      for(int x = xs[0]; x <= xs[1]; ++x)
      {
        std::array<double, 3> w;
        for(std::size_t k = 0; k < 3; ++k)
        {
          const Seen &a = t[(k + 1) % 3], &b = t[(k + 2) % 3];
          w[k] = ((b.x - a.x) * (y + 0.5 - a.y) - (b.y - a.y) * (x + 0.5 - a.x)) / area;
        }
        if(w[0] < 0 || w[1] < 0 || w[2] < 0)
          continue;
        const double inverse = w[0] / t[0].depth + w[1] / t[1].depth + w[2] / t[2].depth;
        Scene_color c = color;
        if(grid && is_odd_cell(*grid, corners, w, t, inverse))
          for(double& channel : c)
            channel *= 0.7;
        put(x, y, 1 / inverse, c);
      }
  }

  static bool is_odd_cell(const std::vector<std::array<double, 2>>& grid, const std::array<std::size_t, 3>& corners,
                          const std::array<double, 3>& w, const std::array<Seen, 3>& t, double inverse)
  {
    double cells = 0;
    for(std::size_t j = 0; j < 2; ++j)
    {
      double u = 0;
      for(std::size_t k = 0; k < 3; ++k)
        u += w[k] / t[k].depth / inverse * grid[corners[k]][j];
      cells += std::floor(u);
    }
    return std::fmod(cells, 2.) != 0;
  }

  void draw_disk(double x, double y, double depth, double radius, const Scene_color& color)
  {
    for(int j = static_cast<int>(std::floor(y - radius)); j <= y + radius; ++j)
      for(int i = static_cast<int>(std::floor(x - radius)); i <= x + radius; ++i)
        if(std::hypot(i + 0.5 - x, j + 0.5 - y) <= radius)
          put(i, j, depth, color);
  }

  void draw_point(const Vector_3& p, const Scene_color& color)
  {
    const Seen s = seen(p, nearer_marks);
    draw_disk(s.x, s.y, s.depth, samples * radius_of_points, color);
  }

  // Disks beside each other along the line.
  void draw_line(const Vector_3& p, const Vector_3& q, const Scene_color& color, double share)
  {
    const Seen a = seen(p, share), b = seen(q, share);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const int steps = static_cast<int>(std::ceil(length)) + 1;
    for(int i = 0; i <= steps; ++i)
    {
      const double s = double(i) / steps;
      const double inverse = (1 - s) / a.depth + s / b.depth;
      draw_disk(a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), 1 / inverse, samples * width_of_lines / 2, color);
    }
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_SCENE_RASTERIZER_H
