// The fields of a settings struct by reflection: how many there are, and where each begins.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace skydrop::test {

namespace detail {

struct AnyValue {
  template <class T>
  operator T() const;  // never called
};

template <class Struct, std::size_t... I>
constexpr bool takesValues(std::index_sequence<I...>) {
  return requires { Struct{(static_cast<void>(I), AnyValue{})...}; };
}

template <class T>
struct IsArray : std::false_type {};
template <class T, std::size_t N>
struct IsArray<std::array<T, N>> : std::true_type {};

}  // namespace detail

inline constexpr std::size_t kMostFields = 48;

// Of an aggregate: the most values that it can be initialised with.
template <class Struct, std::size_t N = kMostFields>
constexpr std::size_t fieldCount() {
  static_assert(std::is_aggregate_v<Struct>);
  static_assert(!detail::takesValues<Struct>(std::make_index_sequence<kMostFields + 1>()),
                "more fields than struct_fields.h knows of");
  if constexpr (detail::takesValues<Struct>(std::make_index_sequence<N>()))
    return N;
  else
    return fieldCount<Struct, N - 1>();
}

#define SKYDROP_FIELDS(count, ...) \
  if constexpr (n == count) {      \
    auto& [__VA_ARGS__] = object;  \
    each(__VA_ARGS__);             \
  }

// Calls visit(field) with each field, in order.
template <class Struct, class Visit>
void forEachField(Struct& object, const Visit& visit) {
  constexpr std::size_t n = fieldCount<Struct>();
  const auto each = [&](auto&... fields) { (visit(fields), ...); };
  SKYDROP_FIELDS(1, f0)
  SKYDROP_FIELDS(2, f0, f1)
  SKYDROP_FIELDS(3, f0, f1, f2)
  SKYDROP_FIELDS(4, f0, f1, f2, f3)
  SKYDROP_FIELDS(5, f0, f1, f2, f3, f4)
  SKYDROP_FIELDS(6, f0, f1, f2, f3, f4, f5)
  SKYDROP_FIELDS(7, f0, f1, f2, f3, f4, f5, f6)
  SKYDROP_FIELDS(8, f0, f1, f2, f3, f4, f5, f6, f7)
  SKYDROP_FIELDS(9, f0, f1, f2, f3, f4, f5, f6, f7, f8)
  SKYDROP_FIELDS(10, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9)
  SKYDROP_FIELDS(11, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10)
  SKYDROP_FIELDS(12, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11)
  SKYDROP_FIELDS(13, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12)
  SKYDROP_FIELDS(14, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13)
  SKYDROP_FIELDS(15, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14)
  SKYDROP_FIELDS(16, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15)
  SKYDROP_FIELDS(17, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16)
  SKYDROP_FIELDS(18, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17)
  SKYDROP_FIELDS(19, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18)
  SKYDROP_FIELDS(20, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19)
  SKYDROP_FIELDS(21, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20)
  SKYDROP_FIELDS(22, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21)
  SKYDROP_FIELDS(23, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22)
  SKYDROP_FIELDS(24, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23)
  SKYDROP_FIELDS(25, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24)
  SKYDROP_FIELDS(26, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25)
  SKYDROP_FIELDS(27, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26)
  SKYDROP_FIELDS(28, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27)
  SKYDROP_FIELDS(29, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28)
  SKYDROP_FIELDS(30, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29)
  SKYDROP_FIELDS(31, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30)
  SKYDROP_FIELDS(32, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31)
  SKYDROP_FIELDS(33, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32)
  SKYDROP_FIELDS(34, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33)
  SKYDROP_FIELDS(35, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33, f34)
  SKYDROP_FIELDS(36, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33, f34, f35)
  SKYDROP_FIELDS(37, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33, f34, f35, f36)
  SKYDROP_FIELDS(38, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33, f34, f35, f36, f37)
  SKYDROP_FIELDS(39, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33, f34, f35, f36, f37,
                 f38)
  SKYDROP_FIELDS(40, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33, f34, f35, f36, f37,
                 f38, f39)
  SKYDROP_FIELDS(41, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33, f34, f35, f36, f37,
                 f38, f39, f40)
  SKYDROP_FIELDS(42, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33, f34, f35, f36, f37,
                 f38, f39, f40, f41)
  SKYDROP_FIELDS(43, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33, f34, f35, f36, f37,
                 f38, f39, f40, f41, f42)
  SKYDROP_FIELDS(44, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33, f34, f35, f36, f37,
                 f38, f39, f40, f41, f42, f43)
  SKYDROP_FIELDS(45, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33, f34, f35, f36, f37,
                 f38, f39, f40, f41, f42, f43, f44)
  SKYDROP_FIELDS(46, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33, f34, f35, f36, f37,
                 f38, f39, f40, f41, f42, f43, f44, f45)
  SKYDROP_FIELDS(47, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33, f34, f35, f36, f37,
                 f38, f39, f40, f41, f42, f43, f44, f45, f46)
  SKYDROP_FIELDS(48, f0, f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19,
                 f20, f21, f22, f23, f24, f25, f26, f27, f28, f29, f30, f31, f32, f33, f34, f35, f36, f37,
                 f38, f39, f40, f41, f42, f43, f44, f45, f46, f47)
}

#undef SKYDROP_FIELDS

// The same with each value, through structs and arrays within.
template <class Object, class Visit>
void forEachValue(Object& object, const Visit& visit) {
  if constexpr (detail::IsArray<Object>::value) {
    for (auto& element : object) forEachValue(element, visit);
  } else if constexpr (std::is_class_v<Object>) {
    forEachField(object, [&](auto& field) { forEachValue(field, visit); });
  } else {
    visit(object);
  }
}

}  // namespace skydrop::test
