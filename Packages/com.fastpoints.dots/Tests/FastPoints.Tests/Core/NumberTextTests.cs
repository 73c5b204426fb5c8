using System.Globalization;
using NUnit.Framework;
using Unity.Mathematics;
using Random = System.Random;

namespace FastPoints.Tests.Core
{
    [Category("Smoke")]
    public class NumberTextTests
    {
        [TestCase(0.0, "0")]
        [TestCase(-0.0, "-0")]
        [TestCase(1, "1")]
        [TestCase(-1.5, "-1.5")]
        [TestCase(0.1, "0.1")]
        [TestCase(848935.2000000001, "848935.2000000001")]
        [TestCase(1.0 / 3, "0.3333333333333333")]
        [TestCase(0.0001, "0.0001")]
        [TestCase(0.00001, "1E-05")]
        [TestCase(0.00012345, "0.00012345")]
        [TestCase(0.000012345, "1.2345E-05")]
        [TestCase(5e-324, "5E-324")]
        [TestCase(1e-323, "1E-323")]
        [TestCase(2.2250738585072014E-308, "2.2250738585072014E-308")]
        [TestCase(2.225073858507201E-308, "2.225073858507201E-308")]
        [TestCase(1.7976931348623157E308, "1.7976931348623157E+308")]
        [TestCase(9007199254740991.0, "9007199254740991")]
        [TestCase(9007199254740992.0, "9007199254740992")]
        [TestCase(9007199254740993.0, "9007199254740992")]
        [TestCase(9007199254740994.0, "9007199254740994")]
        [TestCase(18014398509481984.0, "18014398509481984")]
        [TestCase(99999999999999980.0, "99999999999999980")]
        [TestCase(99999999999999984.0, "99999999999999980")]
        [TestCase(1e16, "10000000000000000")]
        [TestCase(1e17, "1E+17")]
        [TestCase(123456789012345680.0, "1.2345678901234568E+17")]
        [TestCase(1e22, "1E+22")]
        [TestCase(1e23, "1E+23")]
        [TestCase(2.98023223876953125E-08, "2.9802322387695312E-08")]
        [TestCase(double.NaN, "NaN")]
        [TestCase(double.PositiveInfinity, "Infinity")]
        [TestCase(double.NegativeInfinity, "-Infinity")]
        public void Of_HardDouble_IsTheShortestText(double value, string wanted) =>
            Assert.That(NumberText.Of(value), Is.EqualTo(wanted));

        [TestCase(0.1f, "0.1")]
        [TestCase(-0f, "-0")]
        [TestCase(16777216f, "16777216")]
        [TestCase(99999990f, "99999990")]
        [TestCase(123456789f, "123456790")]
        [TestCase(1e9f, "1E+09")]
        [TestCase(1e-5f, "1E-05")]
        [TestCase(1.401298e-45f, "1E-45")]
        [TestCase(1.17549435e-38f, "1.1754944E-38")]
        [TestCase(3.40282347e38f, "3.4028235E+38")]
        [TestCase(float.NaN, "NaN")]
        [TestCase(float.NegativeInfinity, "-Infinity")]
        public void Of_HardFloat_IsTheShortestText(float value, string wanted) =>
            Assert.That(NumberText.Of(value), Is.EqualTo(wanted));

        [Test]
        public void Of_EveryPowerOfTen_BeginsWithOne()
        {
            for (int power = -307; power <= 308; power++)
            {
                string text = "1E" + power.ToString(CultureInfo.InvariantCulture);
                Assert.That(NumberText.TryRead(text, out double value), Is.True);
                string got = NumberText.Of(value);
                Assert.That(got.Replace("0", "").Replace(".", "").Split('E')[0], Is.EqualTo("1"), text);
            }
        }

        [Test]
        public void Of_SeededBits_RoundTripsInTheShortestText()
        {
            var random = new Random(23);
            for (int i = 0; i < 50000; i++)
            {
                ulong bits = (ulong)random.Next() << 33 ^ (ulong)random.Next() << 11 ^ (uint)random.Next();
                // Powers of two have nearer neighbours on one side.
                double value = math.asdouble(i % 8 == 0 ? bits & 0x7FF0000000000000 : bits);
                string text = NumberText.Of(value);
                if (double.IsNaN(value) || double.IsInfinity(value) || value == 0)
                    continue;
                Assert.That(NumberText.TryRead(text, out double back) && math.asulong(back) == math.asulong(value), text);
                Assert.That(ExactNumber.IsNearest(text, value), text);
                if (Shortened(text, out string below, out string above))
                    Assert.That(ExactNumber.IsNearest(below, value) || ExactNumber.IsNearest(above, value), Is.False, text);
            }
        }

        static bool Shortened(string text, out string below, out string above)
        {
            int e = text.IndexOf('E');
            string exponent = e < 0 ? "" : text.Substring(e), number = e < 0 ? text : text.Substring(0, e);
            int last = number.Length - 1;
            while (number[last] == '0' || number[last] == '.')
                last--;
            below = number.Substring(0, last) + "0" + number.Substring(last + 1) + exponent;
            above = "";
            int digits = 0;
            foreach (char c in number)
                digits += c >= '0' && c <= '9' ? 1 : 0;
            if (digits < 2)
                return false;
            var up = number.Substring(0, last).ToCharArray();
            int carry = last - 1;
            while (carry >= 0 && (up[carry] == '9' || up[carry] == '.'))
            {
                if (up[carry] == '9')
                    up[carry] = '0';
                carry--;
            }
            if (carry < 0 || up[carry] == '-')
                return false;
            up[carry]++;
            above = new string(up) + "0" + number.Substring(last + 1) + exponent;
            return true;
        }

        [TestCase("9007199254740993", 9007199254740992.0)]
        [TestCase("9007199254740992.9999999999999999999999999999999999999", 9007199254740992.0)]
        [TestCase("9007199254740993.0000000000000000000000000000000000001", 9007199254740994.0)]
        [TestCase("1915661855173280143737792968751e-20", 19156618551.732802)]
        [TestCase("4.9e-324", 5e-324)]
        [TestCase("2.4703282292062327e-324", 0.0)]
        [TestCase("1e309", double.PositiveInfinity)]
        [TestCase("-.5", -0.5)]
        [TestCase("+5.", 5.0)]
        public void TryRead_HardText_IsTheNearest(string text, double wanted)
        {
            Assert.That(NumberText.TryRead(text, out double value), Is.True);
            Assert.That(math.asulong(value), Is.EqualTo(math.asulong(wanted)));
        }

        [TestCase(""), TestCase(" 1"), TestCase("1 "), TestCase("1 2"), TestCase("1,5"), TestCase("1\u0661")]
        [TestCase("0x10")]
        public void TryRead_NoNumber_IsRefused(string text) => Assert.That(NumberText.TryRead(text, out _), Is.False);
    }
}
