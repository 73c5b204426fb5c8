using System;
using System.Collections;

namespace UnityEngine.TestTools
{
    public class EnterPlayMode : IEditModeTestYieldInstruction
    {
        public EnterPlayMode(bool expectDomainReload = true)
        {
            ExpectDomainReload = expectDomainReload;
        }

        public bool ExpectDomainReload { get; }

        public bool ExpectedPlaymodeState => true;

        public IEnumerator Perform() => throw new NotSupportedException("play mode takes an editor");
    }

    public class ExitPlayMode : IEditModeTestYieldInstruction
    {
        public bool ExpectDomainReload => false;

        public bool ExpectedPlaymodeState => false;

        public IEnumerator Perform() => throw new NotSupportedException("play mode takes an editor");
    }
}
