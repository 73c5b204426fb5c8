using FastPoints.Las;
using NUnit.Framework;

namespace FastPoints.Tests.Las
{
    public class LasPointFormatTests
    {
        [Test]
        public void Format_RecordBytes_AreTheSpecifications([Range(0, 10)] int id) =>
            Assert.That(LasPointFormat.Of(id).RecordBytes, Is.EqualTo(LasTestFile.RecordBytesOfFormat[id]));

        [Test]
        public void Format_Fields_CoverEachBitOfTheRecordOnce([Range(0, 10)] int id)
        {
            var format = LasPointFormat.Of(id);
            var takenBits = new byte[format.RecordBytes];
            foreach (var field in format.Fields)
                for (int i = 0; i < field.Type.SizeOf(); i++)
                {
                    int bits = field.IsBits ? (1 << field.BitWidth) - 1 << field.BitShift : 255;
                    Assert.That(takenBits[field.ByteOffset + i] & bits, Is.Zero, field.Name);
                    takenBits[field.ByteOffset + i] |= (byte)bits;
                }
            Assert.That(takenBits, Is.All.EqualTo(255));
        }

        [Test]
        public void Format_ColorTimeAndWaves_HaveTheSpecifiedOffsets()
        {
            Assert.That(Having(AttributeNames.Red), Is.EqualTo(new[] { 2, 3, 5, 7, 8, 10 }));
            Assert.That(Having(AttributeNames.GpsTime), Is.EqualTo(new[] { 1, 3, 4, 5, 6, 7, 8, 9, 10 }));
            Assert.That(Having(AttributeNames.NearInfrared), Is.EqualTo(new[] { 8, 10 }));
            Assert.That(Having(AttributeNames.WaveformPacketSize), Is.EqualTo(new[] { 4, 5, 9, 10 }));
        }

        static int[] Having(string name)
        {
            var ids = new System.Collections.Generic.List<int>();
            for (int id = 0; id < LasPointFormat.Count; id++)
                foreach (var field in LasPointFormat.Of(id).Fields)
                    if (field.Name == name)
                        ids.Add(id);
            return ids.ToArray();
        }
    }
}
