using System.Runtime.CompilerServices;

// The public types are for users; the package, its tests and its command line share the rest.
[assembly: InternalsVisibleTo("FastPoints.Scenes")]
[assembly: InternalsVisibleTo("FastPoints.Picture")]
[assembly: InternalsVisibleTo("FastPoints.Editor")]
[assembly: InternalsVisibleTo("FastPoints.Evaluation")]
[assembly: InternalsVisibleTo("FastPoints.Benchmarks")]
[assembly: InternalsVisibleTo("FastPoints.Tests")]
[assembly: InternalsVisibleTo("FastPoints.UnityTests")]
[assembly: InternalsVisibleTo("FastPoints.Cli")]
[assembly: InternalsVisibleTo("HostTests")]
[assembly: InternalsVisibleTo("PageTests")]
[assembly: InternalsVisibleTo("MonoTests")]
