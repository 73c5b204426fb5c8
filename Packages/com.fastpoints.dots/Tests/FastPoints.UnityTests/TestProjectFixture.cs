using System.Collections;
using NUnit.Framework;
using UnityEditor;
using UnityEngine.TestTools;

namespace FastPoints.UnityTests
{
    /// <summary>Each test begins with an empty folder in Assets and leaves the project as it was, play mode too.</summary>
    public abstract class TestProjectFixture
    {
        const string Begun = "FastPoints.UnityTests.Begun";

        /// <summary>No [SetUp]: scripts may be loaded anew within a test, and that would run again in the middle of it.</summary>
        [UnitySetUp]
        public IEnumerator BeginProject()
        {
            string test = TestContext.CurrentContext.Test.FullName;
            if (SessionState.GetString(Begun, "") != test)
            {
                TestProject.Begin();
                SessionState.SetString(Begun, test);
            }
            yield break;
        }

        [UnityTearDown]
        public IEnumerator CleanProject()
        {
            if (EditorApplication.isPlaying)
                yield return new ExitPlayMode();
            SessionState.EraseString(Begun);
            TestProject.Clean();
        }
    }
}
