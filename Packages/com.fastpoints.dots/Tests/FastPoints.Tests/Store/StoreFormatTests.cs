using FastPoints.Store;
using NUnit.Framework;

namespace FastPoints.Tests.Store
{
    [Category("Smoke")]
    public unsafe class StoreFormatTests
    {
        [Test]
        public void Records_InMemory_HaveTheirStatedSizes()
        {
            Assert.That(sizeof(FileHeader), Is.EqualTo(FileHeader.SizeBytes));
            Assert.That(sizeof(NodeRecord), Is.EqualTo(NodeRecord.SizeBytes));
            Assert.That(sizeof(PackedRange), Is.EqualTo(PackedRange.SizeBytes));
            Assert.That(sizeof(PageLink), Is.EqualTo(PageLink.SizeBytes));
            Assert.That(sizeof(ContainerRecord), Is.EqualTo(ContainerRecord.SizeBytes));
            Assert.That(sizeof(PageHeader), Is.EqualTo(PageHeader.SizeBytes));
            Assert.That(sizeof(Grid3), Is.EqualTo(24));
            Assert.That(FileHeader.SizeBytes % PlaneShape.AlignmentBytes, Is.EqualTo(0));
        }

        [Test]
        public void Shapes_Descriptors_CountTheirWords()
        {
            Assert.That(new PlaneShape(3, 0).DescriptorWords, Is.EqualTo(5));
            Assert.That(new PlaneShape(3, 7).DescriptorWords, Is.EqualTo(8));
            Assert.That(new PlaneShape(1, 1).DescriptorWords, Is.EqualTo(4));
            Assert.That(new PlaneShape(3, 2).MinimumWord(2), Is.EqualTo(5));
        }

        [Test]
        public void Layout_ColorAndOthers_HavePlanesOfTheirOwn()
        {
            var layout = new StoreLayout(new PointSchema(new[]
            {
                new PointAttribute(AttributeNames.Intensity, AttributeType.UInt16),
                new PointAttribute(AttributeNames.Red, AttributeType.UInt16),
                new PointAttribute(AttributeNames.Green, AttributeType.UInt16),
                new PointAttribute(AttributeNames.Blue, AttributeType.UInt16),
                new PointAttribute(AttributeNames.GpsTime, AttributeType.Float64),
            }));
            Assert.That(layout.Planes.Count, Is.EqualTo(4));
            Assert.That(layout.Planes[1].Name, Is.EqualTo(StoreLayout.ColorName));
            Assert.That(layout.Planes[1].ColumnCount, Is.EqualTo(3));
            Assert.That(layout.Columns[0].RecordOffset, Is.EqualTo(2));
            Assert.That(layout.Planes[3].Shape.WideColumnMask, Is.EqualTo(1));
            Assert.That(layout.AttributeBytes, Is.EqualTo(16));
        }

        [TestCase(AttributeType.Int8), TestCase(AttributeType.Int16), TestCase(AttributeType.Int32)]
        [TestCase(AttributeType.Int64), TestCase(AttributeType.Float32), TestCase(AttributeType.Float64)]
        public void OrderedBits_SignedValues_KeepTheirOrderAndBits(AttributeType type)
        {
            ulong before = 0;
            for (int i = 0; i < 5; i++)
            {
                double value = new[] { -100.0, -1, 0, 1, 100 }[i];
                ulong bits = 0, back = 0;
                switch (type)
                {
                    case AttributeType.Int8: *(sbyte*)&bits = (sbyte)value; break;
                    case AttributeType.Int16: *(short*)&bits = (short)value; break;
                    case AttributeType.Int32: *(int*)&bits = (int)value; break;
                    case AttributeType.Int64: *(long*)&bits = (long)value; break;
                    case AttributeType.Float32: *(float*)&bits = (float)value; break;
                    default: *(double*)&bits = value; break;
                }
                ulong ordered = OrderedBits.Load((byte*)&bits, type);
                OrderedBits.Store(ordered, type, (byte*)&back);
                Assert.That(back, Is.EqualTo(bits));
                if (i > 0)
                    Assert.That(ordered, Is.GreaterThan(before));
                before = ordered;
            }
        }
    }
}
