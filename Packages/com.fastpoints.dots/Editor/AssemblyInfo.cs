using System.Runtime.CompilerServices;

// The public types are for users; the package, its tests and its command line share the rest.
[assembly: InternalsVisibleTo("FastPoints.UnityTests")]
[assembly: InternalsVisibleTo("FastPoints.UnityTests.Performance")]
[assembly: InternalsVisibleTo("HostTests")]
