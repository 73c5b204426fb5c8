using NUnit.Framework;

namespace UnityEngine.TestTools;

/// <summary>A test that is a coroutine, a step a frame.</summary>
[AttributeUsage(AttributeTargets.Method)]
public class UnityTestAttribute : NUnitAttribute { }

/// <summary>Before each test and its [SetUp], as a coroutine.</summary>
[AttributeUsage(AttributeTargets.Method)]
public class UnitySetUpAttribute : NUnitAttribute { }

/// <summary>After each test and its [TearDown], as a coroutine.</summary>
[AttributeUsage(AttributeTargets.Method)]
public class UnityTearDownAttribute : NUnitAttribute { }
