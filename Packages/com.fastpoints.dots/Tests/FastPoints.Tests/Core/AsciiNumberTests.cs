using System;
using System.Globalization;
using System.Text;
using NUnit.Framework;
using Unity.Mathematics;
using Random = System.Random;

namespace FastPoints.Tests.Core
{
    public class AsciiNumberTests
    {
        static unsafe bool TryDouble(string text, out double value, out int taken)
        {
            fixed (byte* start = Encoding.ASCII.GetBytes(text + "\n"))
            {
                byte* p = start;
                bool isNumber = AsciiNumber.TryDouble(ref p, out value);
                taken = (int)(p - start);
                return isNumber;
            }
        }

        static unsafe bool TryFloat(string text, out float value, out int taken)
        {
            fixed (byte* start = Encoding.ASCII.GetBytes(text + "\n"))
            {
                byte* p = start;
                bool isNumber = AsciiNumber.TryFloat(ref p, out value);
                taken = (int)(p - start);
                return isNumber;
            }
        }

        static unsafe bool TryInteger(string text, out ulong magnitude, out bool isNegative, out bool isExact)
        {
            fixed (byte* start = Encoding.ASCII.GetBytes(text + "\n"))
            {
                byte* p = start;
                return AsciiNumber.TryInteger(ref p, out magnitude, out isNegative, out isExact);
            }
        }

        static string Difference(string text)
        {
            if (!TryDouble(text, out double gotDouble, out int taken) || taken != text.Length ||
                !ExactNumber.IsNearest(text, gotDouble))
                return "double " + text + ": " + NumberText.Of(gotDouble);
            if (!TryFloat(text, out float gotFloat, out taken) || taken != text.Length || !ExactNumber.IsNearest(text, gotFloat))
                return "float " + text + ": " + NumberText.Of(gotFloat);
            return null;
        }

        static string Number(Random random, int kind)
        {
            var culture = CultureInfo.InvariantCulture;
            switch (kind)
            {
                case 0:
                    long anyBits = (long)random.Next() << 33 ^ (long)random.Next() << 11 ^ random.Next();
                    double any = BitConverter.Int64BitsToDouble(anyBits);
                    return double.IsNaN(any) || double.IsInfinity(any) ? "1" : NumberText.Of(any);
                case 1:
                    float single = math.asfloat((uint)random.Next());
                    return float.IsNaN(single) || float.IsInfinity(single) ? "2" : NumberText.Of(single);
                case 2:
                    return (random.NextDouble() * 1e6).ToString("F" + random.Next(0, 30), culture);
                case 3:
                    // Half-way between two floats, in few digits and in many.
                    uint bits = (uint)random.Next(0, 0x7F000000);
                    double halfWay = ((double)math.asfloat(bits) + math.asfloat(bits + 1)) / 2;
                    return random.Next(2) == 0 ? NumberText.Of(halfWay) : halfWay.ToString("E60", culture);
                case 4:
                    var text = new StringBuilder(random.Next(2) == 0 ? "-" : "");
                    int digits = random.Next(1, 60), point = random.Next(0, digits + 1);
                    for (int i = 0; i < digits; i++)
                        text.Append(i == point ? "." : "").Append(random.Next(3) == 0 ? 0 : random.Next(10));
                    return text.Append('e').Append(random.Next(-400, 400)).ToString();
                case 5:
                    return (random.Next(-1000000, 1000000) / 1000.0).ToString(culture);
                default:
                    return (random.NextDouble() * Math.Pow(10, random.Next(-40, 40))).ToString("E" + random.Next(5, 22), culture);
            }
        }

        [Test]
        public void TryDouble_SeededNumbers_AreTheNearest([Range(0, 6)] int kind)
        {
            var random = new Random(17 + kind);
            for (int i = 0; i < 20000; i++)
                Assert.That(Difference(Number(random, kind)), Is.Null);
        }

        [TestCase("0")]
        [TestCase("-0")]
        [TestCase("-0.000e5")]
        [TestCase("+5")]
        [TestCase("5.")]
        [TestCase(".5")]
        [TestCase("1E5")]
        [TestCase("1e+05")]
        [TestCase("00000000000000000000000000000001.5")]
        [TestCase("0.000000000000000000000000000000000000000000001")]
        [TestCase("123456789012345678901234567890")]
        [TestCase("9007199254740993")]
        [TestCase("9007199254740992.9999999999999999999999999999999999999")]
        [TestCase("9007199254740993.0000000000000000000000000000000000001")]
        [TestCase("1.7976931348623158e308")]
        [TestCase("1.7976931348623159e308")]
        [TestCase("1e309")]
        [TestCase("1e-400")]
        [TestCase("4.9e-324")]
        [TestCase("2.4703282292062327e-324")]
        [TestCase("2.4703282292062328e-324")]
        [TestCase("2.2250738585072011e-308")]
        [TestCase("3.4028235677973366e38")]
        [TestCase("3.4028235677973367e38")]
        [TestCase("1.1754943508222875e-38")]
        [TestCase("7.006492321624085e-46")]
        [TestCase("7.0064923216240862e-46")]
        [TestCase("1e0000000000000000000001")]
        [TestCase("0e999999999")]
        [TestCase("1.2345678901234567890123456789e-300")]
        public void TryDouble_Border_IsTheNearest(string text) => Assert.That(Difference(text), Is.Null);

        [Test]
        public void TryDouble_ThousandDigitsJustAboveHalfWay_RoundsUp()
        {
            // 2^53 + 1 lies half-way between two doubles; the last digit decides.
            string text = "9007199254740993." + new string('0', 1000) + "1";
            Assert.That(TryDouble(text, out double value, out int taken), Is.True);
            Assert.That(value, Is.EqualTo(9007199254740994.0));
            Assert.That(taken, Is.EqualTo(text.Length));
        }

        [TestCase("nan"), TestCase("NaN"), TestCase("-nan"), TestCase("-nan(ind)"), TestCase("1.#QNAN")]
        [TestCase("-1.#IND"), TestCase("1.#IND00")]
        public void TryDouble_NotANumberAsWritten_IsNaN(string text)
        {
            Assert.That(TryDouble(text, out double value, out int taken), Is.True);
            Assert.That(double.IsNaN(value), Is.True);
            Assert.That(taken, Is.EqualTo(text.Length));
            Assert.That(TryFloat(text, out float single, out taken), Is.True);
            Assert.That(float.IsNaN(single), Is.True);
        }

        [TestCase("inf", double.PositiveInfinity)]
        [TestCase("+inf", double.PositiveInfinity)]
        [TestCase("-Infinity", double.NegativeInfinity)]
        [TestCase("1.#INF", double.PositiveInfinity)]
        [TestCase("-1.#INF00", double.NegativeInfinity)]
        public void TryDouble_InfinityAsWritten_IsInfinite(string text, double wanted)
        {
            Assert.That(TryDouble(text, out double value, out int taken), Is.True);
            Assert.That(value, Is.EqualTo(wanted));
            Assert.That(TryFloat(text, out float single, out taken), Is.True);
            Assert.That((double)single, Is.EqualTo(wanted));
        }

        [TestCase(""), TestCase("-"), TestCase("."), TestCase("e5"), TestCase("1e"), TestCase("1e+"), TestCase("1x")]
        [TestCase("1.2.3"), TestCase("--1"), TestCase("0x10"), TestCase("1,5"), TestCase("in"), TestCase("foo")]
        public void TryDouble_NoNumber_IsRefusedWhereItStarts(string text)
        {
            Assert.That(TryDouble(text, out double _, out int taken), Is.False);
            Assert.That(taken, Is.EqualTo(0));
            Assert.That(TryInteger(text, out ulong _, out bool _, out bool _), Is.False);
        }

        [TestCase("0", 0ul, false, true)]
        [TestCase("-12", 12ul, true, true)]
        [TestCase("+7", 7ul, false, true)]
        [TestCase("9999999999999999999", 9999999999999999999ul, false, true)]
        [TestCase("18446744073709551615", 18446744073709551615ul, false, true)]
        [TestCase("18446744073709551616", 18446744073709551615ul, false, false)]
        [TestCase("12345678901234567890.5", 12345678901234567890ul, false, false)]
        [TestCase("-99999999999999999999999", 18446744073709551615ul, true, false)]
        [TestCase("12345678901234567890e-10", 1234567890ul, false, false)]
        [TestCase("1e30", 18446744073709551615ul, false, false)]
        [TestCase("3.0", 3ul, false, true)]
        [TestCase("3.7", 3ul, false, false)]
        [TestCase("-3.7", 3ul, true, false)]
        [TestCase("1.5e1", 15ul, false, true)]
        [TestCase("12e3", 12000ul, false, true)]
        [TestCase("nan", 0ul, false, false)]
        [TestCase("-inf", 18446744073709551615ul, true, false)]
        public void TryInteger_Text_GivesMagnitudeAndSign(string text, ulong wanted, bool wantedNegative, bool wantedExact)
        {
            Assert.That(TryInteger(text, out ulong magnitude, out bool isNegative, out bool isExact), Is.True);
            Assert.That(magnitude, Is.EqualTo(wanted));
            Assert.That(isNegative, Is.EqualTo(wantedNegative));
            Assert.That(isExact, Is.EqualTo(wantedExact));
        }
    }
}
