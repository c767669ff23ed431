#pragma once

#include <leptonica/allheaders.h>

#include <memory>

namespace chesil
{

struct DestroyLeptonica
{
    void operator()(Pix* image) const { pixDestroy(&image); }
    void operator()(Numa* numbers) const { numaDestroy(&numbers); }
    void operator()(Boxa* boxes) const { boxaDestroy(&boxes); }
    void operator()(Pixa* images) const { pixaDestroy(&images); }
};

/// What Leptonica gives away, destroyed at the end.
template <class T>
using Owned = std::unique_ptr<T, DestroyLeptonica>;

/// Leptonica reports on standard error; for as long as this lives it is silent, since we throw.
class QuietLeptonica
{
public:
    QuietLeptonica() : before_(setMsgSeverity(L_SEVERITY_NONE)) {}
    ~QuietLeptonica() { setMsgSeverity(before_); }
    QuietLeptonica(const QuietLeptonica&) = delete;
    QuietLeptonica& operator=(const QuietLeptonica&) = delete;

private:
    int before_;
};

} // namespace chesil
