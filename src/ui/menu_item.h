// Small pieces that the sections of the menu share.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "skydrop/ui/imgui_context.h"

namespace skydrop::ui {

// Where a frame drew its items, by name.
using ItemPlaces = std::map<std::string, ScreenRect, std::less<>>;

ScreenRect lastItemRect();

// A text beside the mouse while it is over the last item.
void tooltip(std::string_view text);

// A button that keeps its place in `places` under its label or another name. While not `enabled` it cannot be
// pressed.
bool placedButton(const char* label, const std::string& name, ItemPlaces& places, bool enabled = true);

// The next column of a table, flush right.
void rightCell(const std::string& text);

// `text`, or its beginning and an ellipsis where it is wider than that many pixels.
std::string fittingText(std::string text, float width);

// `text` in a place of so many lines, which is taken whether or not there is a text: what stands below does
// not move when it comes and goes. One that needs more lines loses its middle; pointing at it shows all of
// it.
enum class TextRole { refusal, note };  // what went wrong, what is going on
void textInPlace(std::string_view text, int lines, TextRole role);

}  // namespace skydrop::ui
