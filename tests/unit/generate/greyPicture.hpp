#pragma once

#include "core/base/vector.hpp"

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace chesil::test
{

/// A grey image that is drawn in a test, y down, as images are stored, and written as a PGM file.
class GreyPicture
{
public:
    GreyPicture(int width, int height, double ground, int white = 255)
        : width_(width), height_(height), white_(white),
          grey_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), ground)
    {
    }

    double& at(int x, int y)
    {
        return grey_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                     static_cast<std::size_t>(x)];
    }

    GreyPicture& box(int left, int top, int width, int height, double grey)
    {
        for (int y = top; y < top + height; ++y)
        {
            for (int x = left; x < left + width; ++x)
            {
                at(x, y) = grey;
            }
        }
        return *this;
    }

    /// Each pixel takes the share of `grey` that the disk covers of it (16 x 16 samples), or, if not smooth,
    /// all of it if its centre lies in the disk.
    GreyPicture& disk(const Vector2& centre, double radius, double grey, bool smooth = true)
    {
        const int samples = smooth ? 16 : 1;
        const int reach = static_cast<int>(radius) + 2;
        const int middleX = static_cast<int>(centre.x());
        const int middleY = static_cast<int>(centre.y());
        for (int y = std::max(0, middleY - reach); y < std::min(height_, middleY + reach); ++y)
        {
            for (int x = std::max(0, middleX - reach); x < std::min(width_, middleX + reach); ++x)
            {
                int inside = 0;
                for (int sample = 0; sample < samples * samples; ++sample)
                {
                    const Vector2 point(x + (sample % samples + 0.5) / samples,
                                        y + (sample / samples + 0.5) / samples);
                    inside += (point - centre).norm() <= radius;
                }
                at(x, y) += (grey - at(x, y)) * inside / (samples * samples);
            }
        }
        return *this;
    }

    /// Each pixel takes the share of `grey` that the shape covers of it (16 x 16 samples where it is not all inside or
    /// outside at 9); `inside(point)` in pixels, y down.
    template <class Inside>
    GreyPicture& shape(const Inside& inside, double grey)
    {
        const auto count = [&](int x, int y, int samples, double margin)
        {
            int found = 0;
            for (int sample = 0; sample < samples * samples; ++sample)
            {
                const double step = (1 - 2 * margin) / samples;
                found += inside(Vector2(x + margin + (sample % samples + 0.5) * step,
                                        y + margin + (sample / samples + 0.5) * step));
            }
            return found;
        };
        for (int y = 0; y < height_; ++y)
        {
            for (int x = 0; x < width_; ++x)
            {
                // The outer eight of these lie on the pixel's edge.
                const int coarse = count(x, y, 3, -0.25);
                const double covered = coarse % 9 == 0 ? coarse / 9.0 : count(x, y, 16, 0) / 256.0;
                at(x, y) += (grey - at(x, y)) * covered;
            }
        }
        return *this;
    }

    void write(const std::string& path) const
    {
        std::ofstream file(path);
        file << "P2\n" << width_ << ' ' << height_ << '\n' << white_ << '\n';
        for (const double grey : grey_)
        {
            file << std::lround(grey) << '\n';
        }
    }

private:
    int width_;
    int height_;
    int white_;
    std::vector<double> grey_;
};

} // namespace chesil::test
