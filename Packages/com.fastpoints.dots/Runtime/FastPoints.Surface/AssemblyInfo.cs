using System.Runtime.CompilerServices;

// The public types are for users; the package, its tests and its command line share the rest.
[assembly: InternalsVisibleTo("FastPoints.Benchmarks")]
[assembly: InternalsVisibleTo("FastPoints.Tests")]
[assembly: InternalsVisibleTo("FastPoints.Cli")]
[assembly: InternalsVisibleTo("HostTests")]
