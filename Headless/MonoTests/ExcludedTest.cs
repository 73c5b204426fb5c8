namespace FastPoints.MonoTests
{
    /// <summary>A test that Mono cannot run, and why. Whoever adds one says what of Mono it is: what Unity's Mono does too is a
    /// fault of the package.</summary>
    internal sealed class ExcludedTest
    {
        private const string Brotli = "Mono's native Brotli decoder frees what it never allocated after a damaged "
            + "stream, and the process ends";

        public static readonly IReadOnlyList<ExcludedTest> All = new[]
        {
            new ExcludedTest("FastPoints.Tests.Reading.FormatMutationTests.Mutate(Potree_V2Brotli)", Brotli),
        };

        private ExcludedTest(string name, string reason)
        {
            Name = name;
            Reason = reason;
        }

        public string Name { get; }
        public string Reason { get; }
    }
}
