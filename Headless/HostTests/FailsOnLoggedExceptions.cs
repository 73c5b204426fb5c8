using System;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using StandIns.Engine;

[assembly: FastPoints.HostTests.FailsOnLoggedExceptions]

namespace FastPoints.HostTests;

/// <summary>A test during which an exception was logged fails, as in Unity's runner: what a job or a system throws, nobody
/// else is told.</summary>
[AttributeUsage(AttributeTargets.Assembly)]
sealed class FailsOnLoggedExceptionsAttribute : Attribute, ITestAction
{
    public ActionTargets Targets => ActionTargets.Test;

    public void BeforeTest(ITest test) { }
    public void AfterTest(ITest test) => LoggedExceptions.ThrowFirst();
}
