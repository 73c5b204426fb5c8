using System.IO;
using FastPoints.Reading;
using FastPoints.Sources;
using NUnit.Framework;

namespace FastPoints.Tests.Reading
{
    public sealed class CoordinateSystemTests
    {
        const double UsFoot = 1200.0 / 3937;

        [TestCase(2229, "NAD83 / California zone 5 (ftUS)", UsFoot, 0, "EN")]
        [TestCase(2949, "NAD83(CSRS) / MTM zone 7", 1, 0, "EN")]
        [TestCase(2222, "NAD83 / Arizona East (ft)", 0.3048, 0, "EN")]
        [TestCase(4326, "WGS 84", double.NaN, 0, "NE"), TestCase(4979, "WGS 84", double.NaN, 1, "NE")]
        [TestCase(4807, "NTF (Paris)", 0, 0, "NE"), TestCase(4978, "WGS 84", 1, 0, "--")]
        [TestCase(5703, "NAVD88 height", 0, 1, "U"), TestCase(6360, "NAVD88 height (ftUS)", 0, UsFoot, "U")]
        [TestCase(8718, "NAD83 / California zone 5 (ftUS) + NAVD88 height (ftUS)", UsFoot, UsFoot, "ENU")]
        public void Epsg_OfACode_IsItsNameUnitsAndAxes(int code, string name, double metres, double vertical, string axes)
        {
            var system = EpsgTable.Find(code);

            Assert.That(EpsgTable.NameOf(system), Is.EqualTo(name));
            Assert.That(system.MetresPerUnit, Is.EqualTo(metres).Within(1e-15));
            Assert.That(system.VerticalMetresPerUnit, Is.EqualTo(vertical).Within(1e-15));
            Assert.That(system.Axes, Is.EqualTo(axes));
        }

        [TestCase(0), TestCase(1), TestCase(99999), TestCase(int.MaxValue)]
        public void Epsg_OfNoCode_IsNothing(int code) => Assert.That(EpsgTable.Find(code), Is.Null);

        [TestCase("+proj=lcc +units=us-ft", UsFoot, 0), TestCase("+proj=utm +zone=33", 1, 0)]
        [TestCase("+proj=tmerc +to_meter=1200/3937 +vunits=ft", UsFoot, 0.3048), TestCase("+proj=longlat", double.NaN, 0)]
        [TestCase("+init=epsg:2229", UsFoot, 0), TestCase("+proj=lcc +units=cubits", 0, 0), TestCase("EPSG:2229+5703", UsFoot, 1)]
        [TestCase("urn:ogc:def:crs:EPSG::2949", 1, 0)]
        [TestCase("urn:ogc:def:crs,crs:EPSG::2229,crs:EPSG::6360", UsFoot, UsFoot)]
        [TestCase("BOUNDCRS[SOURCECRS[PROJCRS[\"a\",LENGTHUNIT[\"ft\",0.3048]]],TARGETCRS[GEOGCRS[\"b\"]]]", 0.3048, 0)]
        [TestCase("COMPD_CS[\"c\",PROJCS[\"a\",UNIT[\"m\",1]],VERT_CS[\"v\",UNIT[\"ft\",0.3048]]]", 1, 0.3048)]
        [TestCase("GEOGCRS[\"3D\",CS[ellipsoidal,3],AXIS[\"a\",north,ANGLEUNIT[\"d\",0.0174532925]],AXIS[\"b\",east,ANGLEUNIT["
            + "\"d\",0.0174532925]],AXIS[\"h\",up,LENGTHUNIT[\"ft\",0.3048]]]", double.NaN, 0.3048)]
        [TestCase("GEOGCS[\"Paris\",UNIT[\"grad\",0.0157079632679]]", 0, 0)]
        public void Text_OfEachKind_GivesTheUnits(string text, double metres, double vertical)
        {
            var info = new SourceInfo();
            Assert.That(CrsText.Read(text, info.Crs));
            CrsText.Complete(info);

            Assert.That(info.Crs.MetresPerUnit, Is.EqualTo(metres).Within(1e-12));
            Assert.That(info.Crs.VerticalMetresPerUnit, Is.EqualTo(vertical).Within(1e-12));
        }

        [TestCase("EPSG:"), TestCase("EPSG:2229+"), TestCase("EPSG:1+2+3"), TestCase("2229"), TestCase("urn:ogc:def:crs:OGC::84")]
        public void Text_OfNoKind_IsRefused(string text) => Assert.That(CrsText.Read(text, new CoordinateSystem()), Is.False);

        [TestCase("m", 1), TestCase("us-ft", UsFoot), TestCase("0.001", 0.001), TestCase("1200/3937", UsFoot)]
        [TestCase("cubit", 0), TestCase("-1", 0), TestCase("0", 0), TestCase("1/0", 0), TestCase("", 0), TestCase("nan", 0)]
        public void Unit_ByNameOrNumber_GivesMetres(string text, double metres) =>
            Assert.That(CrsText.MetresOfUnit(text), Is.EqualTo(metres));

        [Test]
        public void Open_TextWithLatAndLon_IsInDegreesWhateverTheirOrder()
        {
            using var folder = new TemporaryFolder();
            string path = Path.Combine(folder.Path, "a.csv");
            File.WriteAllText(path, "lat,lon,height\n52.5,13.4,30\n52.6,13.5,31\n");
            using var reader = PointReaders.Open(path);

            Assert.That(reader.Info.Crs.Units.IsInDegrees);
            Assert.That(reader.Info.Schema[1].Name, Is.EqualTo(AttributeNames.X));
        }

        [Test]
        public void Open_WithAnotherSystemAndUnit_AppliesThem()
        {
            using var folder = new TemporaryFolder();
            string path = Path.Combine(folder.Path, "a.xyz");
            File.WriteAllText(path, "1 2 3\n4 5 6\n");
            using (var reader = PointReaders.Open(path, new ReadOptions { CoordinateSystem = "EPSG:2229+5703" }))
                Assert.That(reader.Info.Crs.Units, Is.EqualTo(new CloudUnits(EpsgTable.MetresPerUnit(9003), 1)));
            using (var reader = PointReaders.Open(path, new ReadOptions { CoordinateSystem = "EPSG:2229", MetresPerUnit = 0.5 }))
                Assert.That(reader.Info.Crs.Units, Is.EqualTo(new CloudUnits(0.5, 0.5)));
            Assert.That(() => PointReaders.Open(path, new ReadOptions { CoordinateSystem = "feet" }),
                Throws.InstanceOf<PointCloudException>().With.Message.Contains("such as EPSG:2229, got feet"));
        }
    }
}
