// Lines, boxes and letters on a sheet of paper, in millimetres from its upper left corner. By
// cairo.
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
  // What is drawn until the next call stays inside; an empty box: everywhere.
  void clip(const PaperBox& box);

  double text_width_mm(const std::string& text, double size_mm);
  // `at`: on the line that the letters stand on. `is_upwards`: turned to read from below.
  void write(const std::string& text, const PaperPoint& at, double size_mm, Anchor anchor,
             bool is_bold = false, bool is_upwards = false);

  // As a PNG.
  std::string png() const;

 private:
  struct Sheet;
  std::unique_ptr<Sheet> sheet_;
};

}  // namespace lsos
