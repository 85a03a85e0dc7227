// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_PARAMETER_CHECKS_H
#define CGAL_QUAD_MESHING_INTERNAL_PARAMETER_CHECKS_H

#include <CGAL/Quad_meshing/parameters.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Checks of arguments at compile time, so that a mistake ends in one sentence.

// An error here names the parameter by its tag, the first template argument.
template <typename Tag, typename... Known>
struct Function_takes_parameter
{
  static constexpr bool value = (std::is_same<Tag, Known>::value || ...);
  static_assert(
    value,
    "This function does not take the named parameter whose tag is the first argument of Function_takes_parameter.");
};

template <typename... Known>
struct Function_takes_parameter<internal_np::all_default_t, Known...> : std::true_type
{
};

// Whether a function that knows some parameters takes all those of a pack.
template <typename Pack, typename... Known>
struct Takes_parameters : std::true_type
{
}; // the end of the chain

template <typename T, typename Tag, typename Base, typename... Known>
struct Takes_parameters<Named_function_parameters<T, Tag, Base>, Known...>
{
  static constexpr bool value =
    Function_takes_parameter<Tag, Known...>::value && Takes_parameters<Base, Known...>::value;
};

template <typename T, typename Tag, typename Base, typename... Known>
struct Takes_parameters<internal_np::Quad_meshing_np_link<T, Tag, Base>, Known...>
{
  static constexpr bool value =
    Function_takes_parameter<Tag, Known...>::value && Takes_parameters<Base, Known...>::value;
};

// Ends in one error, which names the first parameter of a pack that a function does not know.
template <typename NamedParameters, typename... Known>
constexpr void check_parameters()
{
  static_cast<void>(Takes_parameters<NamedParameters, Known...>::value);
}

// Maps are judged by their traits, as calls of Boost's get() fail inside, not in the signature.
template <typename Map, typename Key, typename Value>
struct Is_readable_map
{
  typedef boost::property_traits<Map> Traits;
  static constexpr bool value = std::is_convertible<Key, typename Traits::key_type>::value &&
                                std::is_convertible<typename Traits::value_type, Value>::value;
};

template <typename T, typename = void>
struct Is_optional_like : std::false_type
{
};

template <typename T>
struct Is_optional_like<
  T, std::void_t<decltype(static_cast<bool>(std::declval<const T&>())), decltype(*std::declval<const T&>())>>
  : std::true_type
{
};

template <typename Map, typename Key>
struct Is_readable_map_of_optionals
{
  typedef boost::property_traits<Map> Traits;
  static constexpr bool value =
    std::is_convertible<Key, typename Traits::key_type>::value && Is_optional_like<typename Traits::value_type>::value;
};

// The type of a parameter of a pack, or `Default`.
template <typename Tag, typename NamedParameters, typename Default>
using Parameter_type = typename internal_np::Lookup_named_param_def<Tag, NamedParameters, Default>::type;

template <typename Tag, typename NamedParameters, typename Key, typename Value>
constexpr bool map_parameter_is_readable()
{
  if constexpr(parameters::is_default_parameter<NamedParameters, Tag>::value)
    return true;
  else
    return Is_readable_map<Parameter_type<Tag, NamedParameters, bool>, Key, Value>::value;
}

template <typename Tag, typename NamedParameters, typename Key>
constexpr bool map_parameter_gives_optionals()
{
  if constexpr(parameters::is_default_parameter<NamedParameters, Tag>::value)
    return true;
  else
    return Is_readable_map_of_optionals<Parameter_type<Tag, NamedParameters, bool>, Key>::value;
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_PARAMETER_CHECKS_H
