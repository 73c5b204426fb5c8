using NUnit.Framework;

namespace FastPoints.Tests
{
    static class Failures
    {
        /// <summary>The failure of a call: it must have this code, and be one line that has all these parts.</summary>
        public static PointCloudException Of(TestDelegate call, FailureCode code, params string[] parts)
        {
            var failure = Assert.Throws<PointCloudException>(call);
            Assert.That(failure.Code, Is.EqualTo(code), failure.Message);
            Assert.That(failure.Message, Does.Not.Contain("\n"));
            foreach (string part in parts)
                Assert.That(failure.Message, Does.Contain(part));
            return failure;
        }
    }
}
