namespace FastPoints.MonoTests
{
    public static class Program
    {
        public static int Main(string[] args)
        {
            switch (args.Length == 0 ? "" : args[0])
            {
                case "tests": return TestRun.Run(args.Length > 1 ? args[1] : "");
                case "conversions": return Conversions.Run(args[1]);
                case "bench": return Bench.Run(args[1]);
#if NET
                case "adapt":
                    DebianMono.Adapt(args[1], args[2]);
                    return 0;
#endif
                default:
                    Console.Error.WriteLine(
                        "usage: MonoTests tests [PATTERN] | conversions SCRATCH | bench SCRATCH | adapt FROM TO");
                    return 2;
            }
        }
    }
}
