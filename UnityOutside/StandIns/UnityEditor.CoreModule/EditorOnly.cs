namespace UnityEditor;

/// <summary>What only the package's tests for the Unity editor call: it is compiled here, and compared with Unity's
/// list.</summary>
static class EditorOnly
{
    internal static Exception NotHere(string what) => new NotSupportedException(what + " takes an editor");
}
