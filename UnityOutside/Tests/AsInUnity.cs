using System;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using StandIns.Engine;
using UnityOutside.Graphics;

[assembly: UnityOutside.Tests.AsInUnity]

namespace UnityOutside.Tests;

/// <summary>Each test finds a GPU that is five frames behind, and fails where an exception was logged, as in Unity's runner:
/// what a job or a system throws, nobody else is told.</summary>
[AttributeUsage(AttributeTargets.Assembly)]
sealed class AsInUnityAttribute : Attribute, ITestAction
{
    public ActionTargets Targets => ActionTargets.Test;

    public void BeforeTest(ITest test) => HeadlessGraphics.FramesBehind = 5;
    public void AfterTest(ITest test) => LoggedExceptions.ThrowFirst();
}
