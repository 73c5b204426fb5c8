using System.Runtime.CompilerServices;

// The public types are for users; the package, its tests and its command line share the rest.
[assembly: InternalsVisibleTo("FastPoints.Editor")]
[assembly: InternalsVisibleTo("FastPoints.Surface")]
[assembly: InternalsVisibleTo("FastPoints.Benchmarks")]
[assembly: InternalsVisibleTo("FastPoints.Tests")]
[assembly: InternalsVisibleTo("FastPoints.UnityTests")]
[assembly: InternalsVisibleTo("HostTests")]
