using NUnit.Framework;

namespace FastPoints.Tests.Core
{
    public class AttributeTypesTests
    {
        [TestCase(AttributeType.UInt8, AttributeType.Int8, AttributeType.Int16)]
        [TestCase(AttributeType.UInt8, AttributeType.Int32, AttributeType.Int32)]
        [TestCase(AttributeType.UInt32, AttributeType.Int8, AttributeType.Int64)]
        [TestCase(AttributeType.UInt64, AttributeType.Int8, AttributeType.Float64)]
        [TestCase(AttributeType.Float32, AttributeType.UInt16, AttributeType.Float32)]
        [TestCase(AttributeType.Float32, AttributeType.Int32, AttributeType.Float64)]
        [TestCase(AttributeType.Float32, AttributeType.Float64, AttributeType.Float64)]
        public void Common_OfTwoSchemas_HoldsBoth(AttributeType a, AttributeType b, AttributeType both)
        {
            Assert.That(AttributeTypes.Common(a, b), Is.EqualTo(both));
            Assert.That(AttributeTypes.Common(b, a), Is.EqualTo(both));
        }
    }
}
