using System.Collections;
using UnityEditor;

namespace UnityEngine.TestTools;

public class EnterPlayMode(bool expectDomainReload = true) : IEditModeTestYieldInstruction
{
    public bool ExpectDomainReload { get; } = expectDomainReload;
    public bool ExpectedPlaymodeState => true;

    public IEnumerator Perform()
    {
        if (EditorApplication.isPlaying)
            throw new Exception("Editor is already in PlayMode");
        yield return null;
        EditorApplication.isPlaying = true;
    }
}

public class ExitPlayMode : IEditModeTestYieldInstruction
{
    public bool ExpectDomainReload => false;
    public bool ExpectedPlaymodeState => false;

    public IEnumerator Perform()
    {
        if (!EditorApplication.isPlaying)
            throw new Exception("Editor is already in EditMode");
        yield return null;
        EditorApplication.isPlaying = false;
    }
}
