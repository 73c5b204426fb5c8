using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("FastPoints.Benchmarks")]
[assembly: InternalsVisibleTo("FastPoints.Tests")]
[assembly: InternalsVisibleTo("FastPoints.Cli")]
[assembly: InternalsVisibleTo("HostTests")]
