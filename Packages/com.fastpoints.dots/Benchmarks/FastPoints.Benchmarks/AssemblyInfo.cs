using UnityEngine.Scripting;

// Workloads are found by what they implement: a player would strip them.
[assembly: Preserve]
