#include "core/io/grainTable.hpp"

#include "core/base/setupError.hpp"
#include "unit/randomGrain.hpp"
#include "unit/temporaryFolder.hpp"

#include <gmock/gmock.h>

#include <limits>

using namespace chesil;
using testing::HasSubstr;

namespace
{

const std::string columnNames = "shape, size, x, y, angle, vx, vy, angularVelocity, material, driven";

class GrainTable : public test::TemporaryFolder
{
protected:
    std::string path() const { return folder_ + "/grains.csv"; }

    std::vector<GrainRow> rowsOf(const std::string& content) const
    {
        test::setContent(path(), content);
        return readGrainTable(path());
    }

    void refuses(const std::string& content, std::size_t line, const std::string& found,
                 const std::string& expected) const
    {
        const auto error = test::errorOf<SetupError>([&] { rowsOf(content); });
        EXPECT_EQ(error.file(), path());
        EXPECT_EQ(error.entry(), "line " + std::to_string(line)) << content;
        EXPECT_EQ(error.found(), found) << content;
        EXPECT_EQ(error.expected(), expected) << content;
    }

    void refusesToWrite(const std::vector<GrainRow>& rows, const std::string& found) const
    {
        writeGrainTable(path(), {{"ball"}});
        const std::string before = test::contentOf(path());
        const auto error = test::errorOf<SetupError>([&] { writeGrainTable(path(), rows); });
        EXPECT_EQ(error.file(), path());
        EXPECT_THAT(error.found(), HasSubstr(found));
        EXPECT_EQ(test::contentOf(path()), before);
    }
};

std::vector<GrainRow> randomRows(int number, bool withOptional)
{
    test::RandomSource random(3);
    std::vector<GrainRow> rows;
    for (int i = 0; i < number; ++i)
    {
        GrainRow row;
        row.shape = "grain" + std::to_string(random.integer(1, 9));
        row.position = random.logUniform(1e-9, 1e6) * random.direction();
        row.angle = random.uniform(-30, 30);
        row.velocity = random.logUniform(1e-300, 1e3) * random.direction();
        row.angularVelocity = random.uniform(-1, 1) / 3;
        if (withOptional)
        {
            row.size = random.logUniform(1e-6, 10);
            row.material = i % 3 == 0 ? "quartz" : "glass";
            row.driven = i % 7 == 0;
        }
        rows.push_back(row);
    }
    return rows;
}

void expectSame(const std::vector<GrainRow>& read, const std::vector<GrainRow>& written)
{
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t i = 0; i < read.size(); ++i)
    {
        EXPECT_EQ(read[i].shape, written[i].shape);
        EXPECT_EQ(read[i].size, written[i].size);
        EXPECT_EQ(read[i].position, written[i].position);
        EXPECT_EQ(read[i].angle, written[i].angle);
        EXPECT_EQ(read[i].velocity, written[i].velocity);
        EXPECT_EQ(read[i].angularVelocity, written[i].angularVelocity);
        EXPECT_EQ(read[i].material, written[i].material);
        EXPECT_EQ(read[i].driven, written[i].driven);
        EXPECT_EQ(read[i].line, i + 2);
    }
}

} // namespace

TEST_F(GrainTable, readsBackWhatItWroteToTheBit)
{
    for (const bool withOptional : {false, true})
    {
        const std::vector<GrainRow> written = randomRows(1000, withOptional);
        writeGrainTable(path(), written);
        expectSame(readGrainTable(path()), written);
    }
    EXPECT_EQ(names(), std::vector<std::string>{"grains.csv"});
}

TEST_F(GrainTable, isPlainText)
{
    GrainRow row{"ball", 0.5, Vector2(1, -2), 0.25, Vector2(3, 4), 5, "quartz"};
    writeGrainTable(path(), {row});
    EXPECT_EQ(test::contentOf(path()),
              "shape,size,x,y,angle,vx,vy,angularVelocity,material\nball,0.5,1,-2,0.25,3,4,5,quartz\n");
    row.driven = true;
    writeGrainTable(path(), {row, {"ball", 0.5, Vector2(1, 1), 0, Vector2(0, 0), 0, "glass"}});
    EXPECT_EQ(test::contentOf(path()), "shape,size,x,y,angle,vx,vy,angularVelocity,material,driven\n"
                                       "ball,0.5,1,-2,0.25,3,4,5,quartz,1\nball,0.5,1,1,0,0,0,0,glass,0\n");
}

TEST_F(GrainTable, takesColumnsInAnyOrderAndDefaultsForTheOthers)
{
    const std::vector<GrainRow> rows =
        rowsOf("# settled\n\ny, shape ,x\r\n2,ball,1\n# one more\n-1e-3 , egg, 0x10 # here\n");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].shape, "ball");
    EXPECT_EQ(rows[0].position, Vector2(1, 2));
    EXPECT_EQ(rows[1].shape, "egg");
    EXPECT_EQ(rows[1].position, Vector2(16, -1e-3));
    EXPECT_EQ(rows[1].line, 6u);
    EXPECT_FALSE(rows[0].size);
    EXPECT_EQ(rows[0].angle, 0);
    EXPECT_EQ(rows[0].velocity, Vector2(0, 0));
    EXPECT_EQ(rows[0].angularVelocity, 0);
    EXPECT_EQ(rows[0].material, "");
    EXPECT_FALSE(rows[0].driven);
}

TEST_F(GrainTable, refusesColumnsByName)
{
    const std::string header = "a header line of columns: shape, x, y and any others of " + columnNames;
    refuses("", 1, "the end of the file (cut short?)", header);
    refuses("shape,x,y,z\nball,1,2,3\n", 1, "the column 'z'", "one of " + columnNames);
    refuses("shape,x,y,\nball,1,2,\n", 1, "the column ''", "one of " + columnNames);
    refuses("shape,x,y,x\nball,1,2,3\n", 1, "the column 'x' twice", "each column once");
    refuses("# no shape\nx,y\n1,2\n", 2, "no column 'shape'", header);
    refuses("shape,y\nball,2\n", 1, "no column 'x'", header);
    refuses("shape,x\nball,2\n", 1, "no column 'y'", header);
    // No header at all
    refuses("ball,1,2\n", 1, "the column 'ball'", "one of " + columnNames);
}

TEST_F(GrainTable, refusesRowsByLine)
{
    refuses("shape,x,y\n", 2, "the end of the file (cut short?)", "a row a grain");
    refuses("shape,x,y\nball,1,2\nball,1\n", 3, "2 fields", "3: shape, x, y");
    refuses("shape,x,y\nball,1,2,3\n", 2, "4 fields", "3: shape, x, y");
    refuses("shape,x,y\nball;1;2\n", 2, "1 fields", "3: shape, x, y");
    refuses("shape,x,y\nball,1,two\n", 2, "y 'two'", "a finite number");
    refuses("shape,x,y\nball,1 2,3\n", 2, "x '1 2'", "a finite number");
    refuses("shape,x,y\nball,,3\n", 2, "x ''", "a finite number");
    refuses("shape,x,y\nball,nan,3\n", 2, "x 'nan'", "a finite number");
    refuses("shape,x,y,vx\nball,0,0,1e999\n", 2, "vx '1e999'", "a finite number");
    refuses("shape,x,y\n,1,3\n", 2, "shape ''", "a name");
    refuses("shape,x,y,material\nball,1,3,\n", 2, "material ''", "a name");
    refuses("shape,x,y,size\nball,1,3,0\n", 2, "size '0'", "a number > 0");
    refuses("shape,x,y,size\nball,1,3,-1\n", 2, "size '-1'", "a number > 0");
    refuses("shape,x,y,driven\nball,1,3,yes\n", 2, "driven 'yes'", "0 or 1");
}

TEST_F(GrainTable, refusesToWriteWhatItCouldNotRead)
{
    for (const char* name : {"", "two words", "a,b", "a#b", "\"a\"", "'a"})
    {
        refusesToWrite({{name}}, "the name '" + std::string(name) + "'");
    }
    GrainRow sized{"ball", 1.0};
    refusesToWrite({sized, {"ball"}}, "some rows with, some without");
    refusesToWrite({{"ball"}, sized}, "some rows with, some without");
    GrainRow named{"ball"};
    named.material = "a,b";
    refusesToWrite({named}, "the name 'a,b'");
    refusesToWrite({named, {"ball"}}, "the name 'a,b'");
    EXPECT_THROW(writeGrainTable(folder_ + "/none/grains.csv", {{"ball"}}), SetupError);
    EXPECT_THROW(readGrainTable(folder_ + "/none.csv"), SetupError);
}
