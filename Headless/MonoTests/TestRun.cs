using System.Security;
using System.Text.RegularExpressions;
using FastPoints.Tests;
using NUnit.Framework.Api;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace FastPoints.MonoTests
{
    internal sealed class TestRun : ITestListener
    {
        private readonly TextWriter m_out = Console.Out;
        private int m_passed, m_failed, m_skipped;

        /// <param name="pattern">A part of the full names of the tests to run; all but the long ones where empty.</param>
        public static int Run(string pattern)
        {
            var runner = new NUnitTestAssemblyRunner(new DefaultTestAssemblyBuilder());
            ITest tests = runner.Load(typeof(TestData).Assembly, new Dictionary<string, object>());
            // No run of tests says that an assembly has none.
            if (tests.RunState == RunState.NotRunnable)
            {
                Console.WriteLine("FAILED: " + tests.Properties.Get(PropertyNames.SkipReason));
                return 1;
            }
            var run = new TestRun();
            string filter = pattern.Length > 0
                ? "<filter><test re='1'>" + SecurityElement.Escape(Regex.Escape(pattern)) + "</test></filter>"
                : "<filter><not><or><cat>Long</cat><cat>Large</cat></or></not></filter>";
            var left = new List<string>();
            foreach (ExcludedTest test in ExcludedTest.All)
            {
                if (!Named(tests).Contains(test.Name))
                {
                    run.m_failed++;
                    Console.WriteLine("FAILED: there is no " + test.Name + " to leave out");
                }
                Console.WriteLine("not here: " + test.Name + ": " + test.Reason);
                left.Add("<not><test>" + SecurityElement.Escape(test.Name) + "</test></not>");
            }
            if (left.Count > 0)
                filter = "<filter><and>" + filter.Replace("<filter>", "").Replace("</filter>", "")
                    + string.Concat(left) + "</and></filter>";
            runner.Run(run, TestFilter.FromXml(filter));
            Console.WriteLine(run.m_passed + " passed, " + run.m_failed + " failed, "
                + (run.m_skipped + left.Count) + " skipped");
            return run.m_failed == 0 && run.m_passed > 0 ? 0 : 1;
        }

        private static IEnumerable<string> Named(ITest test) => test.Tests.SelectMany(Named).Append(test.FullName);

        public void TestStarted(ITest test)
        {
            if (Environment.GetEnvironmentVariable("MONO_TESTS_TIMES") != null && !test.IsSuite)
                m_out.WriteLine("begin " + test.FullName);
        }

        public void TestFinished(ITestResult result)
        {
            if (result.Test.IsSuite)
                return;
            if (Environment.GetEnvironmentVariable("MONO_TESTS_TIMES") != null)
                m_out.WriteLine($"{result.Duration:0.000} {result.ResultState} {result.FullName}");
            switch (result.ResultState.Status)
            {
                case TestStatus.Passed:
                case TestStatus.Warning:
                    m_passed++;
                    break;
                case TestStatus.Skipped:
                case TestStatus.Inconclusive:
                    m_skipped++;
                    break;
                default:
                    m_failed++;
                    m_out.WriteLine("FAILED: " + result.FullName + "\n" + result.Message + "\n" + result.StackTrace);
                    break;
            }
        }

        public void TestOutput(TestOutput output)
        {
        }

#if NET
        /// <summary>An old NUnit, as Unity's is, sends none.</summary>
        public void SendMessage(TestMessage message)
        {
        }
#endif
    }
}
