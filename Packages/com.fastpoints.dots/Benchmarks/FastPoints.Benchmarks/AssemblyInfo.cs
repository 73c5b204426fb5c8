using System.Runtime.CompilerServices;
using UnityEngine.Scripting;

// Workloads are found by what they implement: a player would strip them.
[assembly: Preserve]
[assembly: InternalsVisibleTo("FastPoints.Tests")]
[assembly: InternalsVisibleTo("FastPoints.Cli")]
[assembly: InternalsVisibleTo("HostTests")]
