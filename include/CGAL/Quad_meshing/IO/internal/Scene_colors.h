// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_SCENE_COLORS_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_SCENE_COLORS_H

#include <CGAL/Quad_meshing/IO/Scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

typedef std::array<double, 3> Scene_color; // red, green, blue, from 0 to 1

// The colors of the elements of a layer. They are those of the pages, where colors.js computes them.
class Scene_colors
{
  const Scene_numbers* m_numbers;
  Scene_color m_plain;
  double m_low = 0, m_high = 0;

public:
  explicit Scene_colors(const Scene_layer& layer)
    : m_numbers(layer.colored_by >= 0 ? &layer.numbers[static_cast<std::size_t>(layer.colored_by)] : nullptr)
    , m_plain(color_of_name(layer.color))
  {
    if(m_numbers)
      find_range();
  }

  Scene_color operator()(std::size_t element) const
  {
    if(!m_numbers)
      return m_plain;
    const double x = m_numbers->values[element];
    if(!std::isfinite(x))
      return { { 0.6, 0.6, 0.6 } };
    switch(m_numbers->scale)
    {
      case Scene_color_scale::CATEGORIES: return category(x);
      case Scene_color_scale::SIGNED: return signed_color(x);
      case Scene_color_scale::SEQUENCE: break;
    }
    return sequential(m_high != m_low ? (x - m_low) / (m_high - m_low) : 0.5);
  }

private:
  void find_range()
  {
    bool is_first = true;
    for(double x : m_numbers->values)
      if(std::isfinite(x))
      {
        m_low = is_first ? x : (std::min)(m_low, x);
        m_high = is_first ? x : (std::max)(m_high, x);
        is_first = false;
      }
    if(!std::isnan(m_numbers->low))
      m_low = m_numbers->low;
    if(!std::isnan(m_numbers->high))
      m_high = m_numbers->high;
  }

  // Of #rrggbb; gray for all other words of CSS.
  static Scene_color color_of_name(const std::string& name)
  {
    if(name.size() != 7 || name.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos || name[0] != '#')
      return { { 0.7, 0.7, 0.7 } };
    Scene_color c;
    for(std::size_t k = 0; k < 3; ++k)
      c[k] = std::stoi(name.substr(1 + 2 * k, 2), nullptr, 16) / 255.;
    return c;
  }

  static Scene_color sequential(double t)
  {
    static const Scene_color sequence[] = {
      { { 0.27, 0.00, 0.33 } }, { { 0.23, 0.32, 0.55 } }, { { 0.13, 0.57, 0.55 } },
      { { 0.37, 0.79, 0.38 } }, { { 0.99, 0.91, 0.14 } },
    };
    const double x = 4 * (std::min)((std::max)(t, 0.), 1.);
    const int i = (std::min)(static_cast<int>(x), 3);
    Scene_color c;
    for(std::size_t k = 0; k < 3; ++k)
      c[k] = sequence[i][k] + (x - i) * (sequence[i + 1][k] - sequence[i][k]);
    return c;
  }

  static Scene_color signed_color(double x)
  {
    if(x == 0)
      return { { 0.6, 0.6, 0.6 } };
    const double light = std::abs(x) > 1 ? 0.45 : 0;
    return x > 0 ? Scene_color{ { 0.85, light, 0.1 } } : Scene_color{ { 0.1, light, 0.9 } };
  }

  // Hues in steps of the golden section, with a saturation of 0.55.
  static Scene_color category(double n)
  {
    const double turns = n * 0.6180339887498949, hue = turns - std::floor(turns);
    const double lightness = static_cast<long long>(n) & 1 ? 0.68 : 0.52;
    const double chroma = (1 - std::abs(2 * lightness - 1)) * 0.55;
    Scene_color c;
    for(int k = 0; k < 3; ++k)
    {
      // the distance of the hue from that of the channel, in sixths of a turn
      const double turn = hue - k / 3. - std::round(hue - k / 3.);
      c[static_cast<std::size_t>(k)] =
        lightness - chroma / 2 + chroma * (std::min)((std::max)(2 - 6 * std::abs(turn), 0.), 1.);
    }
    return c;
  }
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_SCENE_COLORS_H
