using System.Collections;
using System.Runtime.ExceptionServices;
using NUnit.Framework;
using UnityEditor;

namespace UnityEngine.TestTools;

/// <summary>Runs one test of a class as Unity's runner does in edit mode. Where an instruction has scripts loaded anew, the class
/// is made anew, and so is the test's enumerator, which goes on behind the instruction without its variables. What was done by
/// [UnitySetUp] is known and not done again; [SetUp] is. Fields of the class are gone, which is stricter than Unity: it keeps
/// those that it can serialise. Statics stay here.</summary>
sealed class EditModeRun(Type fixture, string test)
{
    const BindingFlags Any = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    readonly Type m_class = fixture;
    readonly MethodInfo m_test = fixture.GetMethod(test);
    int m_setUps, m_tearDowns, m_step;
    bool m_hasRun;
    Exception m_failure;

    public void Run()
    {
        while (!Continue())
            AssemblyReloadEvents.Reload();
        if (m_failure != null)
            ExceptionDispatchInfo.Throw(m_failure);
    }

    bool Continue()
    {
        object fixture = Activator.CreateInstance(m_class);
        var setUps = Methods<UnitySetUpAttribute>();
        for (; m_setUps < setUps.Count; m_setUps++)
            if (!Steps(fixture, setUps[m_setUps]))
                return false;
        if (!m_hasRun && m_failure == null)
        {
            foreach (var setUp in Methods<SetUpAttribute>())
                Call(fixture, setUp);
            if (m_failure == null && !Steps(fixture, m_test))
                return false;
            foreach (var tearDown in Methods<TearDownAttribute>().AsEnumerable().Reverse())
                Call(fixture, tearDown);
            m_hasRun = true;
        }
        var tearDowns = Methods<UnityTearDownAttribute>().AsEnumerable().Reverse().ToList();
        for (; m_tearDowns < tearDowns.Count; m_tearDowns++)
            if (!Steps(fixture, tearDowns[m_tearDowns]))
                return false;
        return true;
    }

    bool Steps(object fixture, MethodInfo method)
    {
        if (Call(fixture, method) is not IEnumerator steps)
            return true;
        var state = steps.GetType().GetField("<>1__state", BindingFlags.Instance | BindingFlags.NonPublic);
        if (m_step != 0)
            state.SetValue(steps, m_step);
        while (MoveNext(steps))
        {
            m_step = (int)state.GetValue(steps);
            if (steps.Current is not IEditModeTestYieldInstruction instruction)
            {
                for (var inner = steps.Current as IEnumerator; inner != null && MoveNext(inner);)
                    NextFrame();
                NextFrame();
                continue;
            }
            var performed = instruction.Perform();
            while (MoveNext(performed))
                continue;
            if (instruction.ExpectDomainReload)
                return false;
        }
        m_step = 0;
        return true;
    }

    internal Action Frame;

    void NextFrame()
    {
        if (Frame != null && !Application.isBatchMode && Camera.main != null && Camera.main.targetTexture != null)
            Camera.main.Render();
        Frame?.Invoke();
    }

    bool MoveNext(IEnumerator steps)
    {
        try
        {
            return steps.MoveNext();
        }
        catch (Exception e)
        {
            m_failure ??= e;
            return false;
        }
    }

    object Call(object fixture, MethodInfo method)
    {
        try
        {
            return method.Invoke(fixture, null);
        }
        catch (TargetInvocationException e)
        {
            m_failure ??= e.InnerException;
            return null;
        }
    }

    List<MethodInfo> Methods<T>() where T : Attribute
    {
        var found = new List<MethodInfo>();
        for (var type = m_class; type != null; type = type.BaseType)
            found.InsertRange(0, type.GetMethods(Any).Where(m => m.IsDefined(typeof(T), false)));
        return found;
    }
}
