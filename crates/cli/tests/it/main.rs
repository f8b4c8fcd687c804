//! The command as its users meet it: what it prints, what it leaves behind, how it ends.

mod answers;
mod assess;
mod calibration;
mod checked;
mod drawings;
mod drawn;
mod examples;
mod house;
mod interruption;
mod keeping;
mod messages;
mod misuse;
mod particles;
mod records;
mod respond;
mod signals;
mod stage;
mod table_1;
mod tiny;
mod tutorials;
mod twins;
mod update;
mod vary;
mod varying;
mod verdict;
mod walls;
