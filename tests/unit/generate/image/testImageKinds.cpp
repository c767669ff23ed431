#include "core/base/setupError.hpp"
#include "generate/image/imageSummary.hpp"
#include "unit/generate/greyPicture.hpp"
#include "unit/temporaryFolder.hpp"

#include <gmock/gmock.h>

using namespace chesil;
using testing::HasSubstr;
using testing::Not;

namespace
{

class ImageKinds : public test::TemporaryFolder
{
protected:
    std::string saved(const test::GreyPicture& picture)
    {
        picture.write(folder_ + "/picture.pgm");
        return folder_ + "/picture.pgm";
    }

    ImageGrains read(const test::GreyPicture& picture, const ImageSettings& settings = {})
    {
        return readGrains(saved(picture), settings);
    }

    SetupError refusal(const test::GreyPicture& picture, const ImageSettings& settings = {})
    {
        return test::errorOf<SetupError>([&] { read(picture, settings); });
    }
};

ImageSettings lightSettings()
{
    ImageSettings settings;
    settings.lightGrains = true;
    return settings;
}

ImageSettings labelSettings()
{
    ImageSettings settings;
    settings.labels = true;
    return settings;
}

} // namespace

TEST_F(ImageKinds, lightGrainsAreReadWhenAskedFor)
{
    test::GreyPicture picture(80, 60, 20);
    picture.box(10, 10, 20, 20, 200).box(40, 10, 20, 20, 210);
    const ImageGrains image = read(picture, lightSettings());
    EXPECT_EQ(image.grains.size(), 2u);
    EXPECT_EQ(image.grains.at(0).count(), 400);
    EXPECT_EQ(image.borderShare, 0);

    ImageSettings settings = lightSettings();
    settings.threshold = 200;
    EXPECT_EQ(read(picture, settings).grains.size(), 1u);
}

TEST_F(ImageKinds, theOtherContrastIsNamed)
{
    test::GreyPicture light(80, 60, 20);
    light.box(10, 10, 20, 20, 200);
    const SetupError refused = refusal(light);
    EXPECT_THAT(refused.found(), HasSubstr("and 100 % of the border taken as one grain"));
    EXPECT_THAT(refused.expected(), HasSubstr("give -light"));
    test::GreyPicture dark(80, 60, 200);
    dark.box(10, 10, 20, 20, 20);
    EXPECT_THAT(refusal(dark, lightSettings()).expected(), HasSubstr("leave out -light"));
    // A spot in a light grain is found as a grain; the border tells.
    light.box(12, 12, 16, 16, 30);
    const ImageGrains image = read(light);
    EXPECT_EQ(image.grains.size(), 1u);
    EXPECT_THAT(imageFindings(image, {}), HasSubstr("Warning: 100 % of the image's border"));
    // Many cut grains on the border are none of that.
    test::GreyPicture cut(80, 60, 200);
    cut.box(0, 0, 30, 20, 20).box(32, 0, 40, 20, 20).box(0, 22, 20, 30, 20).box(30, 30, 20, 20, 20);
    EXPECT_THAT(imageFindings(read(cut), {}), Not(HasSubstr("border is one grain")));
}

TEST_F(ImageKinds, holesAreFilledAndCounted)
{
    test::GreyPicture picture(120, 60, 200);
    picture.box(10, 10, 40, 40, 20).box(20, 20, 20, 20, 200).box(12, 12, 1, 1, 200);
    // A hollow that is open at a corner only is a hole of the ground, hence none.
    picture.box(60, 10, 40, 40, 20).box(60, 10, 1, 1, 200).box(61, 11, 3, 3, 200);
    const ImageGrains image = read(picture);
    ASSERT_EQ(image.grains.size(), 2u);
    EXPECT_EQ(image.holesFilled, 2);
    EXPECT_EQ(image.grains[0].count(), 1600);
    EXPECT_EQ(image.grains[1].count(), 1600 - 10);
    EXPECT_THAT(imageFindings(image, {}), HasSubstr("Holes filled              2\n"));
}

TEST_F(ImageKinds, sixteenBitsStay)
{
    // 12-bit values of a camera in a 16-bit file: 8 bits of it would be 0 or 1.
    test::GreyPicture picture(80, 60, 300, 65535);
    picture.disk({30.3, 29.8}, 15.2, 40);
    const ImageGrains image = read(picture);
    ASSERT_EQ(image.grains.size(), 1u);
    EXPECT_EQ(image.white, 65535);
    EXPECT_NEAR(image.threshold, 170, 30);
    EXPECT_NEAR(image.grains[0].count(), M_PI * 15.2 * 15.2, 10);
    EXPECT_FALSE(image.grains[0].outline().empty());

    ImageSettings settings;
    settings.threshold = 65535;
    EXPECT_THAT(refusal(picture, settings).expected(), HasSubstr("0 to 65534"));
    settings.threshold = 256;
    EXPECT_EQ(read(picture, settings).grains.size(), 1u);
}

TEST_F(ImageKinds, labelsThatTouchAreGrainsOfTheirOwn)
{
    for (const int white : {255, 65535})
    {
        const int last = white - 1;
        test::GreyPicture picture(100, 60, 0, white);
        // By label, not by place; the second in two pieces, one of them a speck; the last cut by the border.
        picture.box(10, 10, 20, 20, last).box(30, 10, 20, 25, 7).box(60, 50, 3, 3, 7).box(80, 20, 20, 20, 9);
        const ImageGrains image = read(picture, labelSettings());
        EXPECT_EQ(image.kind, ImageKind::labels);
        ASSERT_EQ(image.grains.size(), 2u);
        EXPECT_EQ(image.grains[0].count(), 500);
        EXPECT_EQ(image.grains[0].corner(), Vector2(30, 60 - 35));
        EXPECT_EQ(image.grains[1].count(), 400);
        EXPECT_EQ(image.grains[1].corner(), Vector2(10, 60 - 30));
        EXPECT_EQ(image.specksDropped, 1);
        EXPECT_EQ(image.borderDropped, 1);
        EXPECT_EQ(image.labels, 3);
        EXPECT_EQ(image.labelsInPieces, 1);
        EXPECT_THAT(imageFindings(image, labelSettings()), HasSubstr("Labels in pieces          1 of 3;"));
        EXPECT_TRUE(image.grains[0].outline().empty());
    }
}

TEST_F(ImageKinds, theLabelOfTheGroundMayBeAnother)
{
    test::GreyPicture picture(60, 60, 255);
    picture.box(10, 10, 20, 20, 0).box(30, 10, 20, 20, 1);
    ImageSettings settings = labelSettings();
    EXPECT_EQ(read(picture, settings).grains.size(), 1u); // the ground's frame is at the border
    settings.ground = 255;
    const ImageGrains image = read(picture, settings);
    EXPECT_EQ(image.grains.size(), 2u);
    EXPECT_EQ(image.labelsInPieces, 0);
    EXPECT_THAT(imageFindings(image, settings), Not(HasSubstr("pieces")));
    for (const int ground : {-1, 256})
    {
        settings.ground = ground;
        EXPECT_EQ(refusal(picture, settings).entry(), "ground");
    }
    settings.labels = false;
    settings.ground = 255;
    EXPECT_EQ(refusal(picture, settings).entry(), "ground");
}

TEST_F(ImageKinds, aLabelImageWithoutLabelsIsRefused)
{
    EXPECT_THAT(refusal(test::GreyPicture(60, 60, 0), labelSettings()).found(),
                HasSubstr("no label (the value 0 everywhere)"));
    test::GreyPicture speck(60, 60, 0);
    speck.box(10, 10, 1, 1, 5);
    EXPECT_THAT(refusal(speck, labelSettings()).found(),
                HasSubstr("no whole grain (1 labels; 1 specks of fewer"));
    ImageSettings settings = labelSettings();
    settings.split = true;
    EXPECT_EQ(refusal(speck, settings).entry(), "split");
}

TEST_F(ImageKinds, aPixelIsAGrainIfItMayBe)
{
    test::GreyPicture picture(60, 60, 200);
    picture.box(10, 10, 1, 1, 20);
    EXPECT_THAT(refusal(picture).found(), HasSubstr("1 specks of fewer than 200 pixels"));
    ImageSettings settings;
    settings.minPixels = 1;
    EXPECT_EQ(read(picture, settings).grains.at(0).count(), 1);
}

TEST_F(ImageKinds, anImageTooLargeIsRefusedByItsHeader)
{
    const std::string path = folder_ + "/large.pgm";
    const std::vector<std::string> sizes{"100000 30000", "99999 99999", "2147483647 2147483647",
                                         "99999999999 2"};
    for (const std::string& size : sizes)
    {
        test::setContent(path, "P5\n" + size + "\n255\nabc");
        const SetupError error = test::errorOf<SetupError>([&] { readGrains(path); });
        EXPECT_EQ(error.file(), path);
        EXPECT_THAT(error.found() + error.expected(), HasSubstr("at most 536870911 pixels")) << size;
    }
}

TEST_F(ImageKinds, grainsThatTouchAreNamedOrSplit)
{
    test::GreyPicture picture(300, 80, 220);
    picture.disk({35, 40}, 20, 30).disk({110, 40}, 25, 30).disk({156, 40}, 25, 30).disk({240, 40}, 30, 30);
    ImageSettings settings;
    const ImageGrains whole = read(picture, settings);
    EXPECT_EQ(whole.grains.size(), 3u);
    ASSERT_EQ(whole.touching.size(), 1u);
    const std::size_t index = whole.touching[0].grain;
    EXPECT_NEAR(whole.grains[index].count(), 2 * M_PI * 625, 60);
    EXPECT_THAT(imageFindings(whole, settings),
                HasSubstr("Seem to touch             1: grain" + std::to_string(index + 1) +
                          " (2 parts); -split cuts them apart\n"));
    settings.split = true;
    const ImageGrains cut = read(picture, settings);
    EXPECT_EQ(cut.grains.size(), 4u);
    EXPECT_THAT(imageFindings(cut, settings), HasSubstr("Cut apart                 1: grain"));
}

TEST_F(ImageKinds, aGrainFarFromConvexIsNamedWithItsConvexity)
{
    test::GreyPicture picture(100, 60, 220);
    picture.box(10, 10, 40, 40, 30).box(20, 20, 40, 40, 220).box(70, 20, 20, 20, 30);
    const ImageGrains image = read(picture);
    ASSERT_EQ(image.grains.size(), 2u);
    // 700 pixels in a hull of 40 * 40 - 30 * 30 / 2
    EXPECT_THAT(imageFindings(image, {}), HasSubstr("far from convex  1: grain1 (convexity 0.62)"));
}
