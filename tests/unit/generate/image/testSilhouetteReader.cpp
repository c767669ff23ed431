#include "generate/image/silhouetteReader.hpp"

#include "core/base/setupError.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

using namespace chesil;
using testing::HasSubstr;

namespace
{

/// A grey image that is drawn in the test and written as a PGM file; y down, as images are stored.
class Picture
{
public:
    Picture(int width, int height, int ground)
        : width_(width), height_(height), grey_(std::size_t(width) * height, ground)
    {
    }

    Picture& box(int left, int top, int width, int height, int grey)
    {
        for (int y = top; y < top + height; ++y)
        {
            for (int x = left; x < left + width; ++x)
            {
                grey_[std::size_t(y) * width_ + x] = grey;
            }
        }
        return *this;
    }

    std::string saved() const
    {
        const std::string path =
            testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name() + ".pgm";
        std::ofstream file(path);
        file << "P2\n" << width_ << ' ' << height_ << "\n255\n";
        for (const int grey : grey_)
        {
            file << grey << '\n';
        }
        return path;
    }

private:
    int width_;
    int height_;
    std::vector<int> grey_;
};

SetupError refusal(const std::string& path, const ImageSettings& settings = {})
{
    try
    {
        readGrains(path, settings);
    }
    catch (const SetupError& error)
    {
        EXPECT_EQ(error.file(), path);
        return error;
    }
    ADD_FAILURE() << "not refused: " << path;
    return SetupError("", "", "", "");
}

} // namespace

TEST(SilhouetteReader, findsAGrainAndTurnsTheImageOver)
{
    // An L of 20 x 20 with a foot of 40 x 5 below it, its box 3 pixels below the top of the image.
    Picture picture(60, 50, 220);
    picture.box(10, 3, 20, 20, 30).box(10, 23, 40, 5, 30);
    const ImageGrains image = readGrains(picture.saved());
    EXPECT_EQ(image.width, 60);
    EXPECT_EQ(image.height, 50);
    ASSERT_EQ(image.grains.size(), 1u);
    const Silhouette& grain = image.grains[0];
    EXPECT_EQ(grain.count(), 600);
    EXPECT_EQ(grain.width(), 40);
    EXPECT_EQ(grain.height(), 25);
    EXPECT_EQ(grain.corner(), Vector2(10, 50 - 3 - 25));
    EXPECT_TRUE(grain.dark(39, 0));
    EXPECT_FALSE(grain.dark(39, 24));
    EXPECT_TRUE(grain.dark(0, 24));
    EXPECT_FALSE(grain.dark(-1, 0));
    EXPECT_FALSE(grain.dark(0, 25));
}

TEST(SilhouetteReader, dropsSpecksAndCutGrainsAndCountsThem)
{
    Picture picture(200, 100, 255);
    picture.box(50, 50, 20, 20, 0);                    // whole
    picture.box(5, 5, 10, 19, 0).box(90, 90, 3, 3, 0); // specks
    picture.box(0, 40, 20, 20, 0)
        .box(180, 40, 20, 20, 0)
        .box(100, 0, 20, 20, 0)
        .box(100, 80, 20, 20, 0); // cut
    const ImageGrains image = readGrains(picture.saved());
    EXPECT_EQ(image.grains.size(), 1u);
    EXPECT_EQ(image.specksDropped, 2);
    EXPECT_EQ(image.borderDropped, 4);

    ImageSettings settings;
    settings.minPixels = 190;
    EXPECT_EQ(readGrains(picture.saved(), settings).grains.size(), 2u);
}

TEST(SilhouetteReader, grainsThatTouchAtACornerStayApart)
{
    Picture picture(60, 60, 255);
    picture.box(5, 5, 20, 20, 0).box(25, 25, 20, 20, 0);
    EXPECT_EQ(readGrains(picture.saved()).grains.size(), 2u);
}

TEST(SilhouetteReader, thresholdSeparatesTheTwoClassesOrIsTheGivenOne)
{
    Picture picture(80, 80, 200);
    picture.box(0, 40, 80, 40, 210).box(10, 10, 20, 20, 90).box(50, 50, 20, 20, 100);
    const ImageGrains found = readGrains(picture.saved());
    EXPECT_EQ(found.grains.size(), 2u);
    EXPECT_EQ(found.threshold, 150); // in the middle between 100 and 200

    ImageSettings settings;
    settings.threshold = 90;
    EXPECT_EQ(readGrains(picture.saved(), settings).grains.size(), 1u);
    settings.threshold = 89;
    EXPECT_THAT(refusal(picture.saved(), settings).found(), HasSubstr("no whole grain"));
}

TEST(SilhouetteReader, everyPairOfGreyValuesIsSeparated)
{
    for (const int dark : {0, 1, 127, 253, 254})
    {
        for (const int light : {1, 128, 254, 255})
        {
            if (dark < light)
            {
                Picture picture(40, 40, light);
                picture.box(10, 10, 20, 20, dark);
                EXPECT_EQ(readGrains(picture.saved()).grains.size(), 1u) << dark << " on " << light;
            }
        }
    }
}

TEST(SilhouetteReader, refusesImagesWithoutAWholeGrain)
{
    for (const int grey : {0, 128, 255})
    {
        EXPECT_THAT(refusal(Picture(50, 40, grey).saved()).found(), HasSubstr(std::to_string(grey))) << grey;
    }
    ImageSettings settings;
    settings.threshold = 100;
    EXPECT_THAT(refusal(Picture(50, 40, 255).saved(), settings).found(), HasSubstr("no whole grain"));
    EXPECT_THAT(refusal(Picture(50, 40, 0).saved(), settings).found(),
                HasSubstr("1 grains touching the border"));
    Picture specks(50, 40, 255);
    specks.box(10, 10, 5, 5, 0).box(20, 20, 5, 5, 0);
    EXPECT_THAT(refusal(specks.saved()).found(), HasSubstr("2 specks of fewer than 200"));
}

TEST(SilhouetteReader, refusesWhatIsNoImage)
{
    EXPECT_THAT(refusal(testing::TempDir() + "noSuchImage.png").found(), HasSubstr("No such file"));
    refusal(testing::TempDir());
    const std::string path = testing::TempDir() + "text.png";
    std::ofstream(path) << "dark grains on a light ground\n";
    EXPECT_THAT(refusal(path).found(), HasSubstr("no image"));
    std::ofstream(path, std::ios::trunc).close();
    EXPECT_THAT(refusal(path).found(), HasSubstr("no image"));
    std::remove(path.c_str());
}

TEST(SilhouetteReader, refusesAPngThatIsCutShort)
{
    const char* project = std::getenv("CHESIL_DIR");
    const std::string whole = std::string(project ? project : ".") + "/tutorials/quickStart/pebbles.png";
    std::ifstream file(whole, std::ios::binary);
    if (!file)
    {
        GTEST_SKIP() << "the quick start's image is not there: " << whole;
    }
    EXPECT_EQ(readGrains(whole).grains.size(), 37u);

    std::ostringstream bytes;
    bytes << file.rdbuf();
    const std::string path = testing::TempDir() + "cut.png";
    for (const double share : {0.001, 0.5, 0.99})
    {
        const auto length = static_cast<std::size_t>(share * static_cast<double>(bytes.str().size()));
        std::ofstream(path, std::ios::binary) << bytes.str().substr(0, length);
        EXPECT_THAT(refusal(path).found(), HasSubstr("cut short")) << share;
    }
    std::remove(path.c_str());
}

TEST(SilhouetteReader, settingsOutOfRangeAreNamed)
{
    Picture picture(40, 40, 255);
    picture.box(10, 10, 20, 20, 0);
    ImageSettings settings;
    settings.minPixels = 0;
    EXPECT_EQ(refusal(picture.saved(), settings).entry(), "minPixels");
    settings.minPixels = 200;
    for (const int threshold : {-1, 255, 300})
    {
        settings.threshold = threshold;
        EXPECT_EQ(refusal(picture.saved(), settings).entry(), "threshold");
    }
}
