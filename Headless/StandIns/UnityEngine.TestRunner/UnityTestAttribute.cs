using System;
using NUnit.Framework;

namespace UnityEngine.TestTools
{
    /// <summary>A test that is a coroutine, a step a frame. Nothing here runs one.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    public class UnityTestAttribute : NUnitAttribute
    {
    }

    /// <summary>After each test, as a coroutine. Nothing here runs one.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    public class UnityTearDownAttribute : NUnitAttribute
    {
    }
}
