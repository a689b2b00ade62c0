#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

#include "skydrop/ui/hud.h"

namespace skydrop::ui {
namespace {

using Tone = HudText::Tone;

// Shares of a line of text.
constexpr float kMargin = 0.5f, kGap = 0.3f, kPadding = 0.35f, kRowPitch = 1.15f, kThrottleBar = 0.35f,
                kTightPadding = 0.15f;  // above and below lines in the middle, where height is scarce
constexpr float kCircleOfHeight = 0.2f, kCircleOfWidth = 0.25f;
constexpr double kPlate = 0.45;
constexpr float kNarrowestMiddle = 14;  // lines of text: a middle below that is left out
constexpr float kLowWindow = 20;        // lines of text: below, the strip with weather keeps three rows
constexpr double kIceShown = 0.02;      // of what the wing carries: below it is not told
constexpr float kDialOfRows = 1.2f, kSmallestDial = 2.4f;  // in rows of the plates; lines of text
constexpr float kPictureOfWidth = 0.26f;
constexpr float kWideWindow = 48;       // lines of text: below, of a package the time alone is told
constexpr double kFaintestPulse = 0.3;  // the drop text never vanishes
constexpr float kDropOfHeight = 0.26f;  // where the drop text stands when there is room

std::string text(const char* format, double value) {
  char buffer[64];
  // A number that would run off its plate is shown by its magnitude.
  std::snprintf(buffer, sizeof buffer, std::abs(value) < 1e6 ? format : "%.2g", value);
  return buffer;
}

std::string distanceText(double metres) {
  return metres < 1000 ? text("%.0f m", metres) : text("%.2f km", metres / 1000);
}

// Rounded first, so that 359.6 reads 000.
std::string compassText(double degrees) {
  return text("%03.0f\u00b0", std::fmod(std::round(degrees), 360.0));
}

// Degrees by which the nose is held into the wind; nothing where they round to none.
std::string crabText(double degrees) {
  const double whole = std::round(degrees);
  return whole == 0 ? "" : text(whole > 0 ? " +%.0f\u00b0" : " %.0f\u00b0", whole);
}

std::string resumeText(const HudKeys& keys) { return keys.pause.empty() ? "" : keys.pause + " resumes"; }

// Places the items of one window size.
class Layouter {
 public:
  Layouter(const Interface& context, float taken)
      : context_(context),
        line_(context.text().pixels),
        margin_(std::floor(kMargin * line_)),
        gap_(std::floor(kGap * line_)),
        padding_(std::floor(kPadding * line_)),
        tight_(std::floor(kTightPadding * line_)),
        pitch_(std::floor(kRowPitch * line_)),
        width_(static_cast<float>(context.width())),
        height_(static_cast<float>(context.height()) - taken),
        middleRight_(width_) {}

  HudLayout run(const HudData& data, std::span<const HelpRow> help, const std::optional<ScreenRect>& menu) {
    if (menu) {
      if (menu->left > width_ - menu->right) {
        middleRight_ = menu->left;
      } else {
        middleLeft_ = menu->right;
      }
    }
    placeScore(data);
    if (data.autopilot || data.frozen || !data.ground.empty()) placeNotes(data);
    float bottom = height_ - margin_;
    if (data.aircraft) bottom = placeInstruments(data) - gap_;
    if (middleRight_ - middleLeft_ < std::min(kNarrowestMiddle * line_, width_)) return std::move(layout_);
    placePackage(data, !help.empty() || data.panel);
    if (!help.empty()) {
      placeHelp(data, help, bottom);
    } else if (data.panel) {
      placePanel(*data.panel, bottom);
    } else {
      placeMiddle(data, bottom);
    }
    return std::move(layout_);
  }

 private:
  struct Row {
    std::string label, value;
  };

  float measure(const std::string& words, bool large = false) const {
    const Typeface& typeface = large ? context_.large() : context_.text();
    return std::ceil(typeface.face->CalcTextSizeA(typeface.pixels, FLT_MAX, 0, words.c_str()).x);
  }

  std::string fit(std::string words, float room) const {
    if (measure(words) <= room) return words;
    const std::string ellipsis = "\u2026";
    while (!words.empty() && measure(words + ellipsis) > room) {
      while (!words.empty() && (static_cast<unsigned char>(words.back()) & 0xc0) == 0x80) words.pop_back();
      if (!words.empty()) words.pop_back();
    }
    return words + ellipsis;
  }

  float topRow() const { return margin_ + line_ + 2 * padding_; }
  float below(float y) const { return y + gap_; }

  void placeScore(const HudData& data) {
    std::string words = "Score " + std::to_string(data.score) + "   Missed " + std::to_string(data.misses);
    if (data.points > 0) words += "   Points " + std::to_string(data.points);
    if (data.cooldownSeconds > 0) words += text("   Reload %.1f s", data.cooldownSeconds);
    words = fit(std::move(words), width_ * 0.6f - margin_);
    HudItem item{"score", {margin_, margin_, margin_ + measure(words) + 2 * padding_, topRow()}, kPlate, {}};
    item.texts.push_back({words, {margin_ + padding_, margin_ + padding_}, Tone::normal});
    layout_.items.push_back(std::move(item));
  }

  // Who flies, and whether time is held.
  void placeNotes(const HudData& data) {
    const char* both = "AUTOPILOT  FROZEN";
    std::string note = data.ground;
    if (data.autopilot || data.frozen) {
      if (!note.empty()) note += "  ";
      note += data.autopilot && data.frozen ? both : data.frozen ? "TIME FROZEN" : "AUTOPILOT";
    }
    const std::string words = fit(note, width_ * 0.35f - margin_);
    const float right = width_ - margin_, left = right - measure(words) - 2 * padding_;
    HudItem item{"notes", {left, margin_, right, topRow()}, kPlate, {}};
    item.texts.push_back({words, {left + padding_, margin_ + padding_}, Tone::accent});
    layout_.items.push_back(std::move(item));
  }

  // Three rows of label and value on a plate whose bottom edge is the window's margin.
  void placeRows(const std::string& name, float left, float right, float top, std::span<const Row> rows) {
    HudItem item{name, {left, top, right, height_ - margin_}, kPlate, {}};
    float y = top + padding_;
    for (const Row& row : rows) {
      item.texts.push_back({row.label, {left + padding_, y}, Tone::dim});
      const float room = right - left - 2.5f * padding_ - measure(row.label);
      const std::string value = fit(row.value, room);
      item.texts.push_back({value, {right - padding_ - measure(value), y}, Tone::normal});
      y += pitch_;
    }
    layout_.items.push_back(std::move(item));
  }

  // The strip along the bottom; returns its upper edge.
  float placeInstruments(const HudData& data) {
    // In a low window three rows have to do: the throttle has its bar, the altitude is left out.
    const bool isLow = height_ < kLowWindow * line_;
    const float count = data.air && !isLow ? 4 : 3;
    const float rows = std::floor(count * pitch_ + kThrottleBar * line_ + 2 * padding_);
    const float wanted = std::min(kCircleOfHeight * height_, kCircleOfWidth * width_);
    const float diameter = std::floor(std::max(wanted, rows));
    const float bottom = height_ - margin_;
    const float circleLeft = std::floor((width_ - diameter) / 2);
    layout_.items.push_back(
        {"navigation", {circleLeft, bottom - diameter, circleLeft + diameter, bottom}, 0, {}});
    layout_.circleRadius = diameter / 2;
    layout_.circleCentre = {circleLeft + diameter / 2, bottom - diameter / 2};

    const float plate = std::min(std::floor(12 * line_), circleLeft - margin_ - gap_);
    // With weather the speed is what instruments show, and the nose does not point where the path leads.
    std::vector<Row> flight = {
        {"Speed", text("%.0f m/s", data.air ? data.air->indicatedMps : data.airspeedMps)}};
    if (data.air) flight.push_back({"Over ground", text("%.0f m/s", data.air->groundMps)});
    flight.push_back({"Heading", compassText(data.headingDeg)});
    if (data.air) flight.back().value += crabText(data.air->crabDeg);
    if (!data.air || !isLow) flight.push_back({"Throttle", text("%.0f %%", 100 * data.throttle)});
    placeRows("flight", margin_, margin_ + plate, bottom - rows, flight);
    const float barTop = bottom - padding_ - std::floor(kThrottleBar * line_) + 1;
    layout_.throttleBar = {margin_ + padding_, barTop, margin_ + plate - padding_, bottom - padding_};

    std::vector<Row> position = {
        {"Altitude", text("%.0f m", data.altitudeM)},
        {"Ground", text("%.0f m", data.heightAboveGroundM)},
        {"Target", data.targetDistanceM ? distanceText(*data.targetDistanceM) : "\u2013"}};
    if (data.air && isLow) position.erase(position.begin());
    if (data.air)
      position.push_back({"Wind", compassText(data.air->windFromDeg) + text(" %.0f m/s", data.air->windMps)});
    placeRows("position", width_ - margin_ - plate, width_ - margin_, bottom - rows, position);
    if (data.instruments) placeInstruments(margin_ + plate, circleLeft, diameter, rows);
    return bottom - std::max(diameter, rows);
  }

  // Three dials on either side of the navigation bar, where there is room for them.
  void placeInstruments(float left, float circleLeft, float tallest, float rows) {
    const float room = circleLeft - left;
    const float size = std::floor(std::min({(room - 4 * gap_) / 3, kDialOfRows * rows, tallest}));
    if (size < kSmallestDial * line_) return;
    const float pitch = (room - 3 * size) / 4 + size, bottom = height_ - margin_;
    std::array<ScreenRect, kInstruments> places;
    for (std::size_t i = 0; i < kInstruments; ++i) {
      const float side = i < 3 ? left : width_ - circleLeft;
      const float x = std::floor(side + static_cast<float>(i % 3) * pitch + (pitch - size));
      places[i] = {x, bottom - size, x + size, bottom};
    }
    layout_.items.push_back({"dials left", {places[0].left, bottom - size, places[2].right, bottom}, 0, {}});
    layout_.items.push_back({"dials right", {places[3].left, bottom - size, places[5].right, bottom}, 0, {}});
    layout_.instruments = places;
  }

  // The package in the air: its picture at the upper right, and under it, or alone, what is known of it.
  void placePackage(const HudData& data, bool isCovered) {
    if (!data.package || isCovered || middleRight_ < width_) return;
    const float top = below(topRow());
    float bottom = top;
    float width = 0;
    if (data.pictureAspect > 0) {
      width = std::floor(kPictureOfWidth * width_);
      const float height = std::floor(width / static_cast<float>(data.pictureAspect));
      layout_.picture = {width_ - margin_ - width, top, width_ - margin_, top + height};
      layout_.items.push_back({"picture", layout_.picture, 0, {}});
      bottom = layout_.picture.bottom + 1;
    }
    const HudPackage& p = *data.package;
    std::string words = text("%.0f s", p.seconds);
    if (width_ >= kWideWindow * line_ && p.missM)
      words += p.hits ? ", on target" : ", " + distanceText(*p.missM) + " off target";
    if (width > 0) words = fit(std::move(words), width - 2 * padding_);
    const float plate = std::max(width, measure(words) + 2 * padding_), right = width_ - margin_;
    HudItem item{"package", {right - plate, bottom, right, bottom + line_ + 2 * tight_}, kPlate, {}};
    item.texts.push_back({words,
                          {right - plate + std::floor((plate - measure(words)) / 2), bottom + tight_},
                          p.hits ? Tone::accent : Tone::normal});
    layout_.items.push_back(std::move(item));
    side_ = plate + gap_;
  }

  // A table on a plate in the middle. What has no room is cut: rows at the end, words with an ellipsis.
  void placePanel(const HudPanel& panel, float bottom) {
    const float top = below(topRow());
    const float room = middleRight_ - middleLeft_ - 2 * margin_ - 2 * padding_;
    std::vector<float> columns;
    for (const std::vector<std::string>& row : panel.rows) {
      columns.resize(std::max(columns.size(), row.size()), 0);
      for (std::size_t i = 0; i < row.size(); ++i) columns[i] = std::max(columns[i], measure(row[i]));
    }
    float wide = 0;
    for (const float column : columns) wide += column + line_;
    if (!columns.empty()) wide -= line_;
    wide = std::min(std::max({wide, measure(panel.title), measure(panel.footer)}), room);
    const float extra = panel.footer.empty() ? 1 : 2;
    const float free = bottom - top - 2 * padding_;
    const auto rows =
        std::min(panel.rows.size(), static_cast<std::size_t>(std::max(free / line_ - extra, 0.0f)));
    const float count = static_cast<float>(rows) + extra;
    const float pitch = std::floor(std::clamp(free / count, line_, 1.4f * line_));
    const float height = pitch * count + 2 * padding_;
    const float left = std::floor((middleLeft_ + middleRight_ - wide) / 2);
    const float panelTop = std::floor(std::max(top, top + (bottom - top - height) / 2));
    HudItem item{"panel", {left - padding_, panelTop, left + wide + padding_, panelTop + height}, 0.72, {}};
    float y = panelTop + padding_;
    item.texts.push_back({fit(panel.title, wide), {left, y}, Tone::accent});
    for (std::size_t r = 0; r < rows; ++r) {
      y += pitch;
      float x = left;
      for (std::size_t i = 0; i < panel.rows[r].size() && x < left + wide; ++i) {
        const float end = i + 1 < panel.rows[r].size() ? std::min(x + columns[i], left + wide) : left + wide;
        item.texts.push_back({fit(panel.rows[r][i], end - x), {x, y}, i == 0 ? Tone::normal : Tone::dim});
        x += columns[i] + line_;
      }
    }
    if (!panel.footer.empty())
      item.texts.push_back({fit(panel.footer, wide), {left, y + pitch}, Tone::accent});
    layout_.items.push_back(std::move(item));
  }

  // `side`: what stands at the right, and is left free on either side.
  HudText centred(std::string words, float y, Tone tone, bool large, double opacity = 1,
                  float side = 0) const {
    if (!large)
      words = fit(std::move(words), middleRight_ - middleLeft_ - 2 * margin_ - 2 * padding_ - 2 * side);
    const float x = std::floor((middleLeft_ + middleRight_ - measure(words, large)) / 2);
    return {std::move(words), {x, y}, tone, large, opacity};
  }

  // A plate around centred lines, from `top` down.
  HudItem block(std::string name, float top, std::vector<HudText> texts, double plate) const {
    HudItem item{std::move(name), {width_, top, 0, top}, plate, std::move(texts)};
    for (const HudText& line : item.texts) {
      const float x = line.position.x;
      item.rect.left = std::min(item.rect.left, x - padding_);
      item.rect.right = std::max(item.rect.right, x + measure(line.text, line.large) + padding_);
      item.rect.bottom =
          std::max(item.rect.bottom, line.position.y + (line.large ? 2 * line_ : line_) + tight_);
    }
    return item;
  }

  // Messages, drop text, pause and warning share what lies between the score and the instruments. Each has
  // its own place whether the others are there or not, so nothing jumps.
  void placeMiddle(const HudData& data, float bottom) {
    const float messagesTop = below(topRow());
    const float messagesBottom = messagesTop + 3 * line_ + 2 * tight_;
    float y = messagesTop + tight_;
    std::vector<HudText> lines;
    for (const HudMessage& message : data.messages) {
      lines.push_back(centred(message.text, y, Tone::normal, false, message.opacity, side_));
      y += line_;
    }
    if (!lines.empty()) layout_.items.push_back(block("messages", messagesTop, std::move(lines), kPlate));

    const float blockHeight = 3 * line_ + 2 * tight_, warningHeight = line_ + 2 * tight_;
    const float warningTop = bottom - warningHeight;
    const float dropTop = std::floor(std::max(
        below(messagesBottom), std::min(kDropOfHeight * height_, warningTop - 2 * (blockHeight + gap_))));
    if (data.pullUp) {
      layout_.items.push_back(
          block("pull up", dropTop,
                {centred("PULL UP", dropTop + tight_, Tone::warning, true),
                 centred("ground ahead", dropTop + tight_ + 2 * line_, Tone::warning, false)},
                kPlate));
    } else if (data.dropPulse) {
      const double opacity = kFaintestPulse + (1 - kFaintestPulse) * *data.dropPulse;
      layout_.items.push_back(
          block("drop", dropTop,
                {centred("DROP", dropTop + tight_, Tone::accent, true, opacity),
                 centred(data.keys.drop, dropTop + tight_ + 2 * line_, Tone::accent, false, opacity)},
                0));
    }
    if (data.paused) {
      const float above = dropTop + blockHeight + gap_;
      const float pauseTop = std::floor(std::max(above, std::min(height_ / 2, bottom - blockHeight)));
      layout_.items.push_back(
          block("pause", pauseTop,
                {centred("PAUSED", pauseTop + tight_, Tone::normal, true),
                 centred(resumeText(data.keys), pauseTop + tight_ + 2 * line_, Tone::dim, false)},
                kPlate));
    }
    std::string warning;
    Tone tone = Tone::warning;
    double opacity = 1;
    if (data.respawnSeconds) {
      warning = text("Crashed: back in %.1f s", *data.respawnSeconds);
      if (!data.crashReason.empty())
        warning = data.crashReason + text(": back in %.1f s", *data.respawnSeconds);
      if (!data.keys.reset.empty()) warning += ", " + data.keys.reset + " begins again";
    } else if (data.stalled) {
      warning = "STALL: nose down";
    } else if (data.stallWarning) {
      warning = "Stall warning";
      tone = Tone::accent;
    } else if (data.air && data.air->icing >= kIceShown) {
      warning = text("Ice on the wing: %.0f %%", 100 * data.air->icing);
      tone = Tone::accent;
    } else if (data.hintOpacity > 0 && !data.keys.help.empty()) {
      warning = data.keys.help + ": controls";
      tone = Tone::normal;
      opacity = data.hintOpacity;
    }
    // In a pause there is nothing to warn of, and its text needs the room in low windows.
    if (!warning.empty() && !data.paused) {
      HudItem item =
          block("warning", warningTop, {centred(warning, warningTop + tight_, tone, false, opacity)}, kPlate);
      item.rect.bottom = warningTop + warningHeight;
      layout_.items.push_back(std::move(item));
    }
  }

  // Two columns of keys and meanings in the middle; what else stands there waits while the help is open.
  void placeHelp(const HudData& data, std::span<const HelpRow> help, float bottom) {
    const std::size_t perColumn = (help.size() + 1) / 2;
    float keys = 0, meanings = 0;
    for (const HelpRow& row : help) {
      keys = std::max(keys, measure(row.keys));
      meanings = std::max(meanings, measure(row.meaning));
    }
    const float room = (middleRight_ - middleLeft_ - 2 * margin_ - 2 * padding_ - line_) / 2;
    const float column = std::min(keys + line_ + meanings, room);
    // Many inputs leave half of a narrow column to the meanings.
    keys = std::min(keys, std::max(column / 2, column - line_ - meanings));
    const float panel = 2 * column + line_ + 2 * padding_;
    const float top = below(topRow());
    // The rows stand closer where the window is low.
    const float free = (bottom - top - 2 * padding_) / static_cast<float>(perColumn + 1);
    const float rowPitch = std::floor(std::clamp(free, line_, 1.4f * line_));
    const float panelHeight = rowPitch * static_cast<float>(perColumn + 1) + 2 * padding_;
    const float panelTop = std::floor(std::max(top, top + (bottom - top - panelHeight) / 2));
    const float left = std::floor((middleLeft_ + middleRight_ - panel) / 2);
    HudItem item{"help", {left, panelTop, left + panel, panelTop + panelHeight}, 0.72, {}};
    item.texts.push_back({data.paused ? "Controls (paused)" : "Controls",
                          {left + padding_, panelTop + padding_},
                          Tone::accent});
    for (std::size_t i = 0; i < help.size(); ++i) {
      const float x = left + padding_ + (i < perColumn ? 0 : column + line_);
      const float y = panelTop + padding_ + rowPitch * static_cast<float>(1 + i % perColumn);
      item.texts.push_back({fit(help[i].keys, keys), {x, y}, Tone::normal});
      item.texts.push_back({fit(help[i].meaning, column - keys - line_), {x + keys + line_, y}, Tone::dim});
    }
    layout_.items.push_back(std::move(item));
  }

  const Interface& context_;
  float line_, margin_, gap_, padding_, tight_, pitch_, width_, height_;
  float middleLeft_ = 0, middleRight_;  // what the menu leaves
  float side_ = 0;                      // that the package takes of it at the right
  HudLayout layout_;
};

}  // namespace

HudLayout layoutHud(const Interface& context, const HudData& data, std::span<const HelpRow> help,
                    const std::optional<ScreenRect>& menu, float taken) {
  return Layouter(context, taken).run(data, help, menu);
}

}  // namespace skydrop::ui
