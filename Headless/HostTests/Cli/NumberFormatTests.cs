namespace FastPoints.HostTests.Cli;

public sealed class NumberFormatTests
{
    [TestCase(0, ExpectedResult = "0")]
    [TestCase(5.96851, ExpectedResult = "5.969")]
    [TestCase(-0.0123456, ExpectedResult = "-0.01235")]
    [TestCase(0.1, ExpectedResult = "0.1")]
    [TestCase(12345.6, ExpectedResult = "12346")]
    [TestCase(1.5e-9, ExpectedResult = "1.5e-9")]
    [TestCase(2.34567e9, ExpectedResult = "2.346e9")]
    [TestCase(double.PositiveInfinity, ExpectedResult = "Infinity")]
    [TestCase(double.NaN, ExpectedResult = "NaN")]
    public string Measured_Value_HasFourDigits(double value) => NumberFormat.FourDigits(value);
}
