using FastPoints.Text;
using NUnit.Framework;

namespace FastPoints.Tests.Text
{
    public class PlyNamesTests
    {
        static string[] Names(params string[] names)
        {
            var element = new PlyElement { Name = "vertex" };
            foreach (string name in names)
                element.Properties.Add(new PlyProperty { Name = name.TrimEnd('*'), IsList = name.EndsWith("*") });
            return PlyNames.Of(element);
        }

        [TestCase("x y z", "X Y Z")]
        [TestCase("X Y Z", "X Y Z")]
        [TestCase("red green blue alpha", "Red Green Blue Alpha")]
        [TestCase("diffuse_red diffuse_green diffuse_blue", "Red Green Blue")]
        [TestCase("r g b a", "Red Green Blue Alpha")]
        [TestCase("r x a", "r X a")]
        [TestCase("nx ny nz", "NormalX NormalY NormalZ")]
        [TestCase("intensity", "Intensity")]
        [TestCase("scalar_Intensity", "Intensity")]
        [TestCase("reflectance", "Intensity")]
        [TestCase("intensity scalar_Intensity", "Intensity scalar_Intensity")]
        [TestCase("red green blue r g b", "Red Green Blue r g b")]
        [TestCase("confidence scalar_GPS f_dc_0", "confidence scalar_GPS f_dc_0")]
        [TestCase("scalar_Classification scalar_GPS_time return_number", "Classification GpsTime ReturnNumber")]
        [TestCase("numberofreturns ScanAngleRank scalar_Point_Source_ID", "NumberOfReturns ScanAngle PointSourceId")]
        [TestCase("classification scalar_Classification", "Classification scalar_Classification")]
        [TestCase("las:gpsTime las: class_ scalar", "GpsTime las: Classification scalar")]
        [TestCase("p p p", "p p_2 p_3")]
        [TestCase("x Intensity X", "X Intensity X_2")]
        public void Of_Properties_GivesTheUsualNames(string given, string wanted) =>
            Assert.That(string.Join(" ", Names(given.Split(' '))), Is.EqualTo(wanted));

        [Test]
        public void Of_List_HasNoName() =>
            Assert.That(Names("x", "red*", "y"), Is.EqualTo(new[] { AttributeNames.X, null, AttributeNames.Y }));
    }
}
