using NUnit.Framework;

namespace Unity.PerformanceTesting;

/// <summary>Begins and ends a performance test in Unity; here a test that wants samples sets
/// <see cref="PerformanceTest.Active"/> itself.</summary>
[AttributeUsage(AttributeTargets.Method)]
public class PerformanceAttribute : CategoryAttribute
{
    public PerformanceAttribute() : base("Performance") { }
}
