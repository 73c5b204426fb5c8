namespace UnityOutside.Hpc;

internal static class CodeLocation
{
    internal static string Of(MethodDefinition method, Instruction at)
    {
        for (Instruction? back = at; back != null; back = back.Previous)
        {
            if (method.DebugInformation.GetSequencePoint(back) is { IsHidden: false } point)
                return $"{Path.GetFileName(point.Document.Url)}:{point.StartLine}";
        }
        return $"IL_{at.Offset:x4}";
    }
}
