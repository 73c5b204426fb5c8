using System;
using System.Collections.Generic;
using System.Text;
using FastPoints.Reading;
using FastPoints.Sources;
using NUnit.Framework;

namespace FastPoints.Tests.Las
{
    public class LasCoordinateSystemTests
    {
        const string Utm = "PROJCS[\"NAD83 / UTM zone 10N\",GEOGCS[\"NAD83\",DATUM[\"D\",SPHEROID[\"GRS 1980\",6378137,298.25,"
            + "AUTHORITY[\"EPSG\",\"7019\"]]],UNIT[\"degree\",0.0174532925199433],AUTHORITY[\"EPSG\",\"4269\"]],"
            + "PROJECTION[\"Transverse_Mercator\"],UNIT[\"metre\",1,AUTHORITY[\"EPSG\",\"9001\"]],AUTHORITY[\"EPSG\",\"26910\"]]";

        [Test]
        public void Wkt1_Projected_GivesNameCodeAndUnit()
        {
            var crs = Read(new LasTestFile { Minor = 4, Format = 6 }
                .Vlr("LASF_Projection", 2112, Encoding.ASCII.GetBytes(Utm + "\0")));
            Assert.That(crs.Wkt, Is.EqualTo(Utm));
            Assert.That(crs.Summary, Is.EqualTo("NAD83 / UTM zone 10N (EPSG:26910)"));
            Assert.That(crs.MetresPerUnit, Is.EqualTo(1));
        }

        [Test]
        public void Wkt1_CompoundInFeet_GivesBothCodes()
        {
            string wkt = "COMPD_CS[\"both\"," + Utm.Replace("\"metre\",1", "\"foot\",0.3048")
                + ",VERT_CS[\"NAVD88\",VERT_DATUM[\"x\",2005],UNIT[\"m\",1.0],AUTHORITY[\"EPSG\",\"5703\"]]]";
            var crs = Read(new LasTestFile { Minor = 4, Format = 6 }.Evlr("LASF_Projection", 2112, Encoding.ASCII.GetBytes(wkt)),
                "EPSG:26910 is 1 m, the file says 0.3048 m");
            Assert.That(crs.Name, Is.EqualTo("both"));
            Assert.That(crs.VerticalMetresPerUnit, Is.EqualTo(1));
            Assert.That(crs.Epsg, Is.EqualTo(26910));
            Assert.That(crs.VerticalEpsg, Is.EqualTo(5703));
            Assert.That(crs.MetresPerUnit, Is.EqualTo(0.3048));
        }

        [TestCase("GEOGCS[\"WGS 84\",UNIT[\"degree\",0.01745],AUTHORITY[\"EPSG\",\"4326\"]]", "WGS 84", 4326, double.NaN)]
        [TestCase("GEOGCRS[\"WGS\",CS[ellipsoidal,2],ANGLEUNIT[\"degree\",0.01745],ID[\"EPSG\",4326]]", "WGS", 4326, double.NaN)]
        [TestCase("GEODCRS[\"ECEF\",CS[Cartesian,3],LENGTHUNIT[\"metre\",1],ID[\"EPSG\",4978]]", "ECEF", 4978, 1)]
        [TestCase("PROJCRS[\"a \"\"b\"\"\",CS[Cartesian,2],AXIS[\"x\",east,LENGTHUNIT[\"ft\",0.3]]]", "a \"b\"", 0, 0.3)]
        [TestCase("PROJCS(\"round\" , UNIT ( \"m\" , 2.5e0 ) )", "round", 0, 2.5)]
        [TestCase("LOCAL_CS[\"no unit\"]", "no unit", 0, 0)]
        [TestCase("PROJCS[\"cut", "cut", 0, 0)]
        public void Wkt_OtherKinds_AreRead(string wkt, string name, int epsg, double metresPerUnit)
        {
            var crs = new CoordinateSystem();
            Assert.That(WktCoordinateSystem.Read(wkt, crs));
            Assert.That(crs.Name, Is.EqualTo(name));
            Assert.That(crs.Epsg, Is.EqualTo(epsg));
            Assert.That(crs.MetresPerUnit, Is.EqualTo(metresPerUnit));
        }

        [TestCase(""), TestCase("]]]]"), TestCase("\"only a name\""), TestCase("nothing of the kind")]
        public void Wkt_NotWkt_IsRefused(string text)
        {
            var crs = new CoordinateSystem();
            Assert.That(WktCoordinateSystem.Read(text, crs), Is.False);
            Assert.That(crs.IsKnown, Is.False);
        }

        [Test]
        public void Wkt_NestedWithoutEnd_IsBounded()
        {
            var crs = new CoordinateSystem();
            Assert.That(WktCoordinateSystem.Read(string.Concat(System.Linq.Enumerable.Repeat("A[\"x\",", 100000)), crs));
            Assert.That(crs.Name, Is.EqualTo("x"));
        }

        [Test]
        public void GeoKeys_Projected_GivesCodesUnitAndCitation()
        {
            var crs = Read(Keys("NAD_1983_UTM|", new double[0], 1024, 0, 1, 1, 3072, 0, 1, 26910, 3073, 34737, 13, 0,
                3076, 0, 1, 9003, 4096, 0, 1, 5703, 4099, 0, 1, 9002), "EPSG:26910 is 1 m, the file says 0.3048006096012");
            Assert.That(crs.Summary, Is.EqualTo("NAD_1983_UTM (EPSG:26910+5703)"));
            Assert.That(crs.MetresPerUnit, Is.EqualTo(1200.0 / 3937).Within(1e-15));
            Assert.That(crs.VerticalMetresPerUnit, Is.EqualTo(0.3048), "4099 rules over the metres of 5703");
            Assert.That(crs.Wkt, Is.Null);
        }

        [Test]
        public void GeoKeys_UnitOfItsOwnSize_IsRead()
        {
            var crs = Read(Keys("", new[] { 7.0, 0.25 }, 1024, 0, 1, 1, 3072, 0, 1, 32767, 3077, 34736, 1, 1));
            Assert.That(crs.Epsg, Is.Zero);
            Assert.That(crs.MetresPerUnit, Is.EqualTo(0.25));
        }

        [Test]
        public void GeoKeys_GeographicOrUtm_ReportTheUnitWithoutAUnitKey()
        {
            Assert.That(Read(Keys("", new double[0], 1024, 0, 1, 2, 2048, 0, 1, 4326)).MetresPerUnit, Is.NaN);
            Assert.That(Read(Keys("", new double[0], 1024, 0, 1, 1, 3072, 0, 1, 32633)).MetresPerUnit, Is.EqualTo(1));
            Assert.That(Read(Keys("", new double[0], 1024, 0, 1, 1, 3072, 0, 1, 2994)).MetresPerUnit, Is.EqualTo(0.3048));
        }

        /// <summary>The geographic key then names what the system is derived from; its own unit is a length.</summary>
        [TestCase(1, 32767, 9001, 0, 1), TestCase(1, 32767, 9003, 0, 1200.0 / 3937), TestCase(1, 32767, 0, 0, 0)]
        [TestCase(1, 0, 9001, 0, 1), TestCase(0, 32767, 0, 0, 0), TestCase(3, 0, 0, 0, 1), TestCase(3, 0, 9002, 0, 0.3048)]
        [TestCase(2, 0, 0, 4326, double.NaN), TestCase(2, 32767, 0, 4326, double.NaN), TestCase(0, 0, 0, 4326, double.NaN)]
        public void GeoKeys_DerivedFromAGeographicSystem_LackItsCodeAndUnit(int model, int projected, int unit, int epsg,
            double metresPerUnit)
        {
            var crs = Read(Keys("", new double[0], 1024, 0, 1, model, 2048, 0, 1, 4326, 3072, 0, 1, projected, 3076, 0, 1, unit));
            Assert.That(crs.Epsg, Is.EqualTo(epsg));
            Assert.That(crs.MetresPerUnit, Is.EqualTo(metresPerUnit).Within(1e-15));
        }

        [Test]
        public void GeoKeys_Invalid_WarnAndPointsLoad()
        {
            using var file = Keys("short", new double[0], 1026, 34737, 60000, 3, 3077, 34736, 1, 5, 3072, 34736, 1, 0,
                3073, 7, 7, 7);
            file.RandomPoints(5).Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.PointCount, Is.EqualTo(5));
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(4));
            Assert.That(reader.Info.Crs.IsKnown, Is.False);
        }

        [Test]
        public void GeoKeys_CountBeyondTheRecord_ReadsTheExistingOnes()
        {
            var directory = LasTestFile.Shorts(1, 1, 0, 60000, 3072, 0, 1, 32633);
            using var file = new LasTestFile().Vlr("LASF_Projection", 34735, directory);
            file.RandomPoints(5).Save();
            using var reader = PointReaders.Open(file.Path);
            Assert.That(reader.Info.Crs.Epsg, Is.EqualTo(32633));
            Assert.That(reader.Info.Warnings.Count, Is.EqualTo(1));
        }

        [Test]
        public void Wkt_BesideGeoKeys_Wins()
        {
            var file = Keys("", new double[0], 3072, 0, 1, 32633).Vlr("LASF_Projection", 2112, Encoding.ASCII.GetBytes(Utm));
            Assert.That(Read(file).Epsg, Is.EqualTo(26910));
        }

        static CoordinateSystem Read(LasTestFile file, string warning = null)
        {
            using (file.RandomPoints(2).Save())
            using (var reader = PointReaders.Open(file.Path))
            {
                if (warning != null)
                    Assert.That(reader.Info.Warnings, Has.Some.Matches<CloudWarning>(w => w.Text.Contains(warning)));
                else
                    Assert.That(reader.Info.Warnings, Is.Empty);
                return reader.Info.Crs;
            }
        }

        static LasTestFile Keys(string text, double[] doubles, params int[] entries)
        {
            var directory = new List<int> { 1, 1, 0, entries.Length / 4 };
            directory.AddRange(entries);
            var numbers = new byte[8 * doubles.Length];
            Buffer.BlockCopy(doubles, 0, numbers, 0, numbers.Length);
            return new LasTestFile().Vlr("LASF_Projection", 34735, LasTestFile.Shorts(directory.ToArray()))
                .Vlr("LASF_Projection", 34736, numbers).Vlr("LASF_Projection", 34737, Encoding.ASCII.GetBytes(text));
        }
    }
}
