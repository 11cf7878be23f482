// Draws lines, boxes and text on a sheet of paper with cairo, in millimetres from its upper left
// corner.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace lsos {

struct PaperPoint {
  double x_mm = 0, y_mm = 0;
};
struct PaperBox {
  double left_mm = 0, top_mm = 0, width_mm = 0, height_mm = 0;
  double right_mm() const { return left_mm + width_mm; }
  double bottom_mm() const { return top_mm + height_mm; }
};

struct Stroke {
  std::string colour = "#000000";
  double width_mm = 0.2;
  std::vector<double> dashes_mm;
};

enum class Anchor { left, middle, right };

class FigurePen {
 public:
  FigurePen(double width_mm, double height_mm, int dpi);
  ~FigurePen();
  FigurePen(const FigurePen&) = delete;
  FigurePen& operator=(const FigurePen&) = delete;

  void fill(const PaperBox& box, const std::string& colour);
  void frame(const PaperBox& box, const Stroke& stroke);
  void line(const std::vector<PaperPoint>& points, const Stroke& stroke);
  // Diagonal lines across a box.
  void hatch(const PaperBox& box, const Stroke& stroke, double apart_mm);
  // Clips what is drawn until the next call to the box; an empty box ends clipping.
  void clip(const PaperBox& box);

  double text_width_mm(const std::string& text, double size_mm);
  // `at`: a point on the baseline. `is_upwards`: rotated to read from bottom to top.
  void write(const std::string& text, const PaperPoint& at, double size_mm, Anchor anchor,
             bool is_bold = false, bool is_upwards = false);

  // The sheet as a PNG.
  std::string png() const;

 private:
  struct Sheet;
  std::unique_ptr<Sheet> sheet_;
};

}  // namespace lsos
