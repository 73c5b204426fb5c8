namespace UnityOutside.Tests.StandIns;

static class JobHandles
{
    /// <summary>Throws what a job threw: Unity logs it.</summary>
    public static void CompleteAndThrow(this JobHandle handle)
    {
        handle.Complete();
        LoggedExceptions.ThrowFirst();
    }
}
