using System.Collections;
using NUnit.Framework;
using UnityEditor;
using UnityEngine.TestTools;

namespace FastPoints.UnityTests
{
    /// <summary>Each test begins with an empty folder in Assets and leaves the project as it was, play mode too.</summary>
    public abstract class TestProjectFixture
    {
        [SetUp]
        public void BeginProject() => TestProject.Begin();

        [UnityTearDown]
        public IEnumerator CleanProject()
        {
            if (EditorApplication.isPlaying)
                yield return new ExitPlayMode();
            TestProject.Clean();
        }
    }
}
